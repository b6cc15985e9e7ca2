// Runs the built program as a user would, and keeps what it said.
#pragma once

#include "tests/files/temporary_folder.h"

#include <sys/types.h>

#include <string>
#include <utility>
#include <vector>

namespace quartic {

struct Answer {
    int code = -1;    // of the exit; -1: a signal ended it
    std::string out;  // standard output
    std::string err;  // standard error
};

using Environment = std::vector<std::pair<std::string, std::string>>;

// Standard input is empty.
Answer run_quartic(const std::vector<std::string>& arguments, const Environment& environment = {});

// A program that waits for its standard input, which nobody writes: for signals.
class WaitingProgram {
public:
    explicit WaitingProgram(const std::vector<std::string>& arguments);
    ~WaitingProgram();
    WaitingProgram(const WaitingProgram&) = delete;
    WaitingProgram& operator=(const WaitingProgram&) = delete;

    // Sends once the program blocks its signals to look at them itself.
    void send(int signal) const;
    int wait_for_code();

private:
    pid_t process_ = -1;
    int input_ = -1;  // the end that is never written
};

std::string read_bytes(const std::string& path);

std::size_t count_lines(const std::string& text);

}  // namespace quartic
