// The verb bench: measures this machine; numbers, not verdicts.
#include "bench/load.h"

#include "cli/arguments.h"
#include "cli/verbs.h"
#include "exporters/rvm.h"
#include "files/output.h"
#include "generators/generate.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <utility>

namespace quartic::cli {
namespace {

using nlohmann::ordered_json;

struct BenchArguments {
    std::string name;
    std::vector<std::string> files;
    int rounds = 9;
    int threads = 0;
    int copies = 1;
    bool csv = false;
    bool markdown = false;
    Reporting reporting;
};

ordered_json load_row(const std::string& method, const Source& model, const LoadFigures& figures,
                      const std::vector<double>& seconds) {
    std::vector<double> sorted = seconds;
    std::sort(sorted.begin(), sorted.end());
    const double median = sorted[sorted.size() / 2];
    return {{"method", method},
            {"file", model.path()},
            {"bytes", figures.bytes},
            {"parts", figures.parts},
            {"cores", method == "parse" ? 1 : figures.thread_count},
            {"median_s", median},
            {"megabytes_per_second", 1e-6 * static_cast<double>(figures.bytes) / median},
            {"parts_per_second", static_cast<double>(figures.parts) / median},
            {"rounds_s", seconds}};
}

Result<Source> open_repeated(const std::string& path, int copies) {
    Result<Source> source = Source::open(path);
    if (!source || copies == 1) {
        return source;
    }
    return repeat_rvm(source.value(), static_cast<std::size_t>(copies));
}

// What is measured where no file is named: a plant that every machine makes alike.
Result<Source> make_sample() {
    constexpr std::uint64_t sample_parts = 1'000'000;
    const Result<Scene> plant = generate("plant", {sample_parts, 1, 0.0, {}});
    if (!plant) {
        return plant.error();
    }
    std::vector<std::byte> bytes;
    Output output = Output::to_memory(bytes);
    Status written = export_rvm(plant.value(), output);
    written = written ? output.commit() : written;
    if (!written) {
        return written.error();
    }
    return Source::from_bytes("generated plant", std::move(bytes));
}

Result<std::vector<Source>> load_models(const BenchArguments& arguments) {
    std::vector<Source> models;
    for (const std::string& path : arguments.files) {
        Result<Source> model = open_repeated(path, arguments.copies);
        if (!model) {
            return model.error();
        }
        models.push_back(std::move(model).value());
    }
    if (models.empty()) {
        Result<Source> model = make_sample();
        if (!model) {
            return model.error();
        }
        models.push_back(std::move(model).value());
    }
    return models;
}

// Two rows for each file: the parser alone where it can be had, and all of the loading.
Result<ordered_json> load_rows(const BenchArguments& arguments) {
    const Result<std::vector<Source>> models = load_models(arguments);
    if (!models) {
        return models.error();
    }
    ordered_json rows = ordered_json::array();
    for (const Source& model : models.value()) {
        const Result<LoadFigures> measured =
            measure_load(model, arguments.rounds, arguments.threads);
        if (!measured) {
            return measured.error();
        }
        const LoadFigures& figures = measured.value();
        if (!figures.parse_s.empty()) {
            rows.push_back(load_row("parse", model, figures, figures.parse_s));
        }
        rows.push_back(load_row("scene", model, figures, figures.scene_s));
    }
    return rows;
}

// A benchmark is a name and what makes its rows.
struct Benchmark {
    std::string_view name;
    Result<ordered_json> (*rows)(const BenchArguments&);
};

constexpr Benchmark benchmarks[] = {
    {"load", load_rows},
};

std::vector<std::string> benchmark_names() {
    std::vector<std::string> names;
    for (const Benchmark& benchmark : benchmarks) {
        names.emplace_back(benchmark.name);
    }
    return names;
}

std::string cell(const ordered_json& value) {
    if (value.is_string()) {
        return value.get<std::string>();
    }
    if (!value.is_number_float()) {
        return value.dump();
    }
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.6g", value.get<double>());
    return text.data();
}

// Lists inside a row are for JSON only.
std::string as_table(const ordered_json& rows, const std::string& separator,
                     const std::string& edge) {
    std::string table;
    for (const ordered_json& row : rows) {
        std::string heads;
        std::string cells;
        std::string rules;
        for (const auto& [key, value] : row.items()) {
            if (!value.is_array()) {
                heads += (heads.empty() ? edge : separator) + key;
                cells += (cells.empty() ? edge : separator) + cell(value);
                rules += "|---";
            }
        }
        if (table.empty()) {
            table = heads + edge + "\n" + (edge.empty() ? std::string() : rules + "|\n");
        }
        table += cells + edge + "\n";
    }
    return table;
}

ExitCode bench(const BenchArguments& arguments) {
    const auto* found =
        std::find_if(std::begin(benchmarks), std::end(benchmarks),
                     [&](const Benchmark& row) { return row.name == arguments.name; });
    const Result<ordered_json> rows = found->rows(arguments);
    if (!rows) {
        return report_error(rows.error());
    }
    if (arguments.reporting.json) {
        return print_json({{"schema", json_schema},
                           {"bench", arguments.name},
                           {"renderer", nullptr},
                           {"clock", "wall"},
                           {"rounds", arguments.rounds},
                           {"rows", rows.value()}});
    }
    if (arguments.csv) {
        return print_text(as_table(rows.value(), ",", ""));
    }
    const std::string heading =
        "wall clock, median of " + std::to_string(arguments.rounds) + " rounds\n\n";
    return print_text(heading + as_table(rows.value(), arguments.markdown ? "|" : "  ",
                                         arguments.markdown ? "|" : ""));
}

}  // namespace

void add_bench(CLI::App& program, Run& run) {
    const auto arguments = std::make_shared<BenchArguments>();
    CLI::App& verb = *program.add_subcommand("bench", "measure this machine");
    verb.footer("Example: quartic bench load plant.rvm --rounds 9 --markdown");
    verb.add_option("NAME", arguments->name, "what to measure")
        ->required()
        ->check(CLI::IsMember(benchmark_names()));
    verb.add_option("FILE", arguments->files,
                    "models to measure with; none: a generated plant of a million parts")
        ->default_str("");
    verb.add_option("--rounds", arguments->rounds, "how often; the median counts")
        ->check(CLI::Range(1, 10000));
    verb.add_option("--threads", arguments->threads, "0: as many as the machine has")
        ->check(CLI::Range(0, 1024));
    verb.add_option("--copies", arguments->copies, "repeats an RVM file in memory, to make it big")
        ->check(CLI::Range(1, 1000000));
    verb.add_flag("--csv", arguments->csv, "as comma-separated values");
    verb.add_flag("--markdown", arguments->markdown, "as a Markdown table");
    add_reporting(verb, arguments->reporting);
    verb.callback([&run, arguments] { run = [arguments] { return bench(*arguments); }; });
}

}  // namespace quartic::cli
