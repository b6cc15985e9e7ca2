// The verb bench: measures this machine; numbers, not verdicts.
#include "bench/benches.h"

#include "cli/arguments.h"
#include "cli/signals.h"
#include "cli/verbs.h"
#include "files/output.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <memory>
#include <span>

namespace quartic::cli {
namespace {

struct BenchArguments {
    std::string name;
    BenchSettings settings;
    std::string size;
    bool csv = false;
    bool markdown = false;
    std::vector<std::string> outputs;
    std::string plot;
    Reporting reporting;
};

std::string as_json_text(const Report& report) {
    nlohmann::ordered_json document{{"schema", json_schema}};
    document.update(as_json(report));
    // Files may have any bytes in their names.
    using Handler = nlohmann::ordered_json::error_handler_t;
    return document.dump(2, ' ', false, Handler::replace) + "\n";
}

std::string as_plot_text(const Report& report) {
    return as_svg(report.plot);
}

// What a report can be written as, by the ending of the file's name.
struct Format {
    std::string_view extension;
    std::string (*text)(const Report&);
};
constexpr Format formats[] = {
    {".json", as_json_text}, {".csv", as_csv},
    {".md", as_markdown},    {".txt", [](const Report& report) { return as_text(report); }},
    {".svg", as_plot_text},
};

const Format* find_format(std::string_view path) {
    const auto* found =
        std::find_if(std::begin(formats), std::end(formats),
                     [&](const Format& format) { return path.ends_with(format.extension); });
    return found == std::end(formats) ? nullptr : found;
}

std::string check_report_path(const std::string& path) {
    return find_format(path) != nullptr
               ? std::string()
               : "expected a name that ends in .json, .csv, .md, .txt or .svg, found '" + path +
                     "'";
}

std::string check_plot_path(const std::string& path) {
    return path.ends_with(".svg") ? std::string()
                                  : "expected a name that ends in .svg, found '" + path + "'";
}

std::vector<std::string> benchmark_names() {
    std::vector<std::string> names;
    for (const BenchRow& row : bench_table()) {
        names.emplace_back(row.name);
    }
    return names;
}

std::string described_benchmarks() {
    std::string text = "Benchmarks:\n";
    for (const BenchRow& row : bench_table()) {
        text += "  " + std::string(row.name) + ": " + std::string(row.what) + "\n";
    }
    return text;
}

ExitCode write_report(const std::string& path, const std::string& text) {
    const Status written = write_file(path, std::as_bytes(std::span(text)));
    return written ? exit_ok : report_error(written.error());
}

// To standard output as the options say, and to every file that was named.
ExitCode write_all(const BenchArguments& arguments, const Report& report) {
    ExitCode code = exit_ok;
    for (const std::string& path : arguments.outputs) {
        code = worse_of(code, write_report(path, find_format(path)->text(report)));
    }
    if (!arguments.plot.empty()) {
        code = worse_of(code, write_report(arguments.plot, as_svg(report.plot)));
    }
    const bool asked = arguments.reporting.json || arguments.csv || arguments.markdown;
    if (!arguments.outputs.empty() && !asked) {
        return code;
    }
    return worse_of(code, print_text(arguments.reporting.json ? as_json_text(report)
                                     : arguments.csv          ? as_csv(report)
                                     : arguments.markdown     ? as_markdown(report)
                                                              : as_text(report)));
}

ExitCode bench(const BenchArguments& arguments) {
    const std::span<const BenchRow> rows = bench_table();
    const auto found = std::find_if(
        rows.begin(), rows.end(), [&](const BenchRow& row) { return row.name == arguments.name; });
    BenchSettings settings = arguments.settings;
    settings.is_stopped = is_interrupted;
    settings.views = settings.views == 0 ? found->views : settings.views;
    if (!arguments.size.empty()) {
        settings.size = *find_size(arguments.size);
    }
    if (arguments.reporting.verbose) {
        settings.note = [&](const std::string& text) {
            report_note(arguments.reporting, arguments.name + ": " + text);
        };
    }
    const Result<Report> report = found->run(settings);
    return report ? write_all(arguments, report.value()) : report_error(report.error());
}

}  // namespace

void add_bench(CLI::App& program, Run& run) {
    const auto arguments = std::make_shared<BenchArguments>();
    CLI::App& verb = *program.add_subcommand("bench", "measure this machine");
    verb.footer(described_benchmarks() +
                "\nExample: quartic bench load plant.rvm --rounds 9 --markdown\n"
                "Example: quartic bench one-torus -o torus.json -o torus.md --plot torus.svg");
    BenchSettings& settings = arguments->settings;
    verb.add_option("NAME", arguments->name, "what to measure")
        ->required()
        ->check(CLI::IsMember(benchmark_names()));
    verb.add_option("FILE", settings.files, "models to measure with, of load and solvers")
        ->default_str("");
    verb.add_option("--rounds", settings.rounds, "how often; the median counts")
        ->check(CLI::Range(1, 10000));
    verb.add_option("--size", arguments->size, "WxH in pixels; left out: as the benchmark has it")
        ->check(check_size);
    verb.add_option("--views", settings.views, "of models and of surfaces (3), and of proxies (48)")
        ->check(CLI::Range(1, 1000))
        ->default_str("");
    verb.add_option("--rays", settings.rays, "how many, in rays; ten billion take a day")
        ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{1'000'000'000'000}));
    verb.add_option("--count-max", settings.count_max, "of tori, in many-tori")
        ->check(CLI::Range(1, 4194304));
    verb.add_option("--threads", settings.threads, "of load; 0: as many as the machine has")
        ->check(CLI::Range(0, 1024));
    verb.add_option("--copies", settings.copies, "repeats an RVM file in memory, to make it big")
        ->check(CLI::Range(1, 1000000));
    verb.add_flag("--software", settings.software, "Mesa's software OpenGL");
    verb.add_flag("--csv", arguments->csv, "as comma-separated values");
    verb.add_flag("--markdown", arguments->markdown, "as a Markdown table");
    verb.add_option("-o,--output", arguments->outputs,
                    "a file to write: .json, .csv, .md, .txt or .svg; may be repeated")
        ->allow_extra_args(false)
        ->check(check_report_path);
    verb.add_option("--plot", arguments->plot, "OUT.svg: writes a plot")->check(check_plot_path);
    add_reporting(verb, arguments->reporting);
    verb.callback([&run, arguments] { run = [arguments] { return bench(*arguments); }; });
}

}  // namespace quartic::cli
