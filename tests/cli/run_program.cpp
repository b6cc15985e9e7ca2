// Starts processes, with their output in files so that no pipe can fill up.
#include "tests/cli/run_program.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <thread>

namespace quartic {
namespace {

// Only what is allowed between fork and exec.
[[noreturn]] void become(std::vector<char*>& arguments, int input, int output, int error) {
    ::dup2(input, STDIN_FILENO);
    ::dup2(output, STDOUT_FILENO);
    ::dup2(error, STDERR_FILENO);
    ::execv(QUARTIC_PROGRAM, arguments.data());
    ::_exit(127);
}

pid_t start(const std::vector<std::string>& arguments, std::array<int, 3> descriptors) {
    std::vector<std::string> texts{QUARTIC_PROGRAM};
    texts.insert(texts.end(), arguments.begin(), arguments.end());
    std::vector<char*> pointers;
    for (std::string& text : texts) {
        pointers.push_back(text.data());
    }
    pointers.push_back(nullptr);
    const pid_t process = ::fork();
    if (process == 0) {
        become(pointers, descriptors[0], descriptors[1], descriptors[2]);
    }
    return process;
}

int wait_for(pid_t process) {
    int status = 0;
    ::waitpid(process, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

bool blocks(pid_t process, int signal) {
    const std::string status = read_bytes("/proc/" + std::to_string(process) + "/status");
    const std::size_t label = status.find("SigBlk:");
    if (label == std::string::npos) {
        return false;
    }
    const unsigned long long mask = std::strtoull(status.c_str() + label + 7, nullptr, 16);
    return (mask >> (signal - 1) & 1) != 0;
}

int open_for_writing(const std::string& path) {
    return ::open(path.c_str(), O_CREAT | O_TRUNC | O_WRONLY | O_CLOEXEC, 0600);
}

}  // namespace

Answer run_quartic(const std::vector<std::string>& arguments, const Environment& environment) {
    const TemporaryFolder folder;
    const int input = ::open("/dev/null", O_RDONLY | O_CLOEXEC);
    const int output = open_for_writing(folder.path("out"));
    const int error = open_for_writing(folder.path("err"));
    for (const auto& [name, value] : environment) {
        ::setenv(name.c_str(), value.c_str(), 1);
    }
    Answer run;
    run.code = wait_for(start(arguments, {input, output, error}));
    for (const auto& [name, value] : environment) {
        ::unsetenv(name.c_str());
    }
    ::close(input);
    ::close(output);
    ::close(error);
    run.out = read_bytes(folder.path("out"));
    run.err = read_bytes(folder.path("err"));
    return run;
}

WaitingProgram::WaitingProgram(const std::vector<std::string>& arguments) {
    std::array<int, 2> pipe{};
    if (::pipe2(pipe.data(), O_CLOEXEC) != 0) {
        return;
    }
    const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
    process_ = start(arguments, {pipe[0], nowhere, nowhere});
    ::close(pipe[0]);
    ::close(nowhere);
    input_ = pipe[1];
}

WaitingProgram::~WaitingProgram() {
    ::close(input_);
    if (process_ > 0) {
        ::kill(process_, SIGKILL);
        wait_for(process_);
    }
}

void WaitingProgram::send(int signal) const {
    for (int tries = 0; tries < 1000 && !blocks(process_, signal); ++tries) {
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    ::kill(process_, signal);
}

int WaitingProgram::wait_for_code() {
    const int code = wait_for(process_);
    process_ = -1;
    return code;
}

std::string read_bytes(const std::string& path) {
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

std::size_t count_lines(const std::string& text) {
    return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

}  // namespace quartic
