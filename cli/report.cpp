// Prints errors, findings and data.
#include "cli/report.h"

#include "files/output.h"

#include <nlohmann/json.hpp>

#include <sys/resource.h>

#include <algorithm>
#include <cstdio>

namespace quartic::cli {
namespace {

// Messages are one line each, whatever a file's name or a library's text holds.
std::string one_line(std::string_view text) {
    std::string line(text);
    std::replace_if(
        line.begin(), line.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20; }, ' ');
    return line;
}

void print_message(std::string_view text) {
    const std::string line = "quartic: " + one_line(text) + "\n";
    std::fwrite(line.data(), 1, line.size(), stderr);
}

std::string described(const Finding& finding) {
    std::string text = finding.where;
    text += text.empty() ? "" : ": ";
    text += std::string(name(finding.severity)) + ": " + finding.text;
    if (finding.count > 1) {
        text += " (" + std::to_string(finding.count) + " times)";
    }
    return text;
}

}  // namespace

ExitCode exit_code(ErrorKind kind) {
    switch (kind) {
        case ErrorKind::bad_data: return exit_failed;
        case ErrorKind::usage: return exit_usage;
        case ErrorKind::io: return exit_io;
        case ErrorKind::no_opengl: return exit_no_opengl;
        case ErrorKind::interrupted: return exit_failed;  // signals.h knows which signal it was
    }
    return exit_failed;
}

ExitCode report_error(const Error& error) {
    print_message(error.where.empty() ? error.message : error.where + ": " + error.message);
    return exit_code(error.kind);
}

ExitCode report_usage(std::string_view where, std::string_view what) {
    return report_error({ErrorKind::usage, std::string(where), std::string(what)});
}

void report_note(const Reporting& reporting, const std::string& text) {
    if (!reporting.quiet) {
        print_message(text);
    }
}

ExitCode report_findings(const std::string& path, const Findings& findings,
                         const Reporting& reporting) {
    for (const Finding& finding : findings.list()) {
        const bool lost = finding.severity == Severity::loss;
        if (lost || reporting.verbose) {
            print_message(path + ": " + described(finding));
        }
    }
    const std::uint64_t lost = findings.count(Severity::loss);
    if (lost == 0) {
        return exit_ok;
    }
    print_message(path + ": done in part: " + std::to_string(lost) +
                  (lost == 1 ? " loss" : " losses") + ", named above");
    return reporting.strict ? exit_failed : exit_partial;
}

ExitCode worse_of(ExitCode left, ExitCode right) {
    if (left == exit_ok || right == exit_ok) {
        return left == exit_ok ? right : left;
    }
    return left == exit_partial ? right : left;
}

ExitCode print_text(std::string_view text) {
    Result<Output> output = Output::create("-");
    if (!output) {
        return report_error(output.error());
    }
    output.value().write(text);
    const Status written = output.value().commit();
    return written ? exit_ok : report_error(written.error());
}

ExitCode print_json(const nlohmann::ordered_json& document) {
    // Names in files need not be UTF-8: what is not is replaced, so that the output always parses.
    using Handler = nlohmann::ordered_json::error_handler_t;
    return print_text(document.dump(2, ' ', false, Handler::replace) + "\n");
}

nlohmann::ordered_json findings_as_json(const Findings& findings) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const Finding& finding : findings.list()) {
        list.push_back({{"severity", name(finding.severity)},
                        {"where", finding.where},
                        {"text", finding.text},
                        {"count", finding.count}});
    }
    return list;
}

std::uint64_t peak_memory_bytes() {
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
}

}  // namespace quartic::cli
