// What the program says: data on standard output, messages on standard error, and its exit codes.
#pragma once

#include "diagnostics/findings.h"
#include "diagnostics/result.h"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <string>
#include <string_view>

namespace quartic::cli {

using ExitCode = int;
constexpr ExitCode exit_ok = 0;
constexpr ExitCode exit_failed = 1;
constexpr ExitCode exit_usage = 2;
constexpr ExitCode exit_partial = 3;
constexpr ExitCode exit_io = 4;
constexpr ExitCode exit_no_opengl = 5;
constexpr ExitCode exit_time_limit = 124;
constexpr ExitCode exit_signal = 128;  // plus the signal's number

// Options that every verb has.
struct Reporting {
    bool json = false;
    bool verbose = false;
    bool quiet = false;
    bool strict = false;            // elements that were lost make the work a failure
    std::string progress = "auto";  // a bar on a terminal; "json", "none"
    int time_limit_s = 0;           // 0: none
};

constexpr int json_schema = 1;

ExitCode exit_code(ErrorKind kind);

// Prints "quartic: where: what" as one line, and returns the exit code of its kind.
ExitCode report_error(const Error& error);
ExitCode report_usage(std::string_view where, std::string_view what);

// For people, on standard error; silent with --quiet.
void report_note(const Reporting& reporting, const std::string& text);

// Says how many elements of the file were lost, and more with --verbose: 0, 3, or 1 if strict.
ExitCode report_findings(const std::string& path, const Findings& findings,
                         const Reporting& reporting);

// The worse of two: what failed outright outranks what was done in part.
ExitCode worse_of(ExitCode left, ExitCode right);

// Writes to standard output; a failure is reported and has its exit code.
ExitCode print_text(std::string_view text);
ExitCode print_json(const nlohmann::ordered_json& document);

nlohmann::ordered_json findings_as_json(const Findings& findings);

// The most memory that this process ever held, resident.
std::uint64_t peak_memory_bytes();

}  // namespace quartic::cli
