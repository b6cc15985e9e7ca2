// The verb generate: models with known truth, made from a seed.
#include "generators/generate.h"
#include "cli/arguments.h"
#include "cli/model.h"
#include "cli/verbs.h"
#include "exporters/save.h"

#include <nlohmann/json.hpp>

#include <memory>

namespace quartic::cli {
namespace {

struct GenerateArguments {
    std::string kind;
    std::string output;
    GenerateOptions options;
    std::string offset = "0,0,0";
    Reporting reporting;
};

std::vector<std::string> kind_names() {
    std::vector<std::string> names;
    for (const GeneratorRow& row : generator_table()) {
        names.emplace_back(row.name);
    }
    return names;
}

std::string described_kinds() {
    std::string text = "Kinds:\n";
    for (const GeneratorRow& row : generator_table()) {
        text += "  " + std::string(row.name) + ": " + std::string(row.what) + "\n";
    }
    return text;
}

ExitCode generate_model(const GenerateArguments& arguments) {
    if (arguments.output == "-" && arguments.reporting.json) {
        return report_usage("-o -",
                            "standard output cannot hold both the model and --json; name a file");
    }
    const Moment start = now();
    GenerateOptions options = arguments.options;
    options.offset = *find_vector(arguments.offset);
    const Result<Scene> scene = generate(arguments.kind, options);
    if (!scene) {
        return report_error(scene.error());
    }
    const Status saved = save_model(scene.value(), arguments.output);
    if (!saved) {
        return report_error(saved.error());
    }
    const std::size_t parts = scene.value().parts.size();
    const Findings findings = export_findings(scene.value(), arguments.output);
    if (arguments.reporting.json) {
        return print_json({{"schema", json_schema},
                           {"kind", arguments.kind},
                           {"file", arguments.output},
                           {"seed", options.seed},
                           {"parts", parts},
                           {"nodes", scene.value().nodes.size()},
                           {"generate_ms", elapsed_ms(start)},
                           {"peak_memory_bytes", peak_memory_bytes()}});
    }
    report_note(arguments.reporting, arguments.output + ": " + std::to_string(parts) + " parts");
    return report_findings(arguments.output, findings, arguments.reporting);
}

}  // namespace

void add_generate(CLI::App& program, Run& run) {
    const auto arguments = std::make_shared<GenerateArguments>();
    CLI::App& verb = *program.add_subcommand("generate", "make a model with known truth");
    verb.footer(described_kinds() +
                "\nExample: quartic generate plant -o plant.rvm --seed 1 --offset 1000,2000,0\n"
                "         quartic generate surfaces -o gallery.pov");
    verb.add_option("KIND", arguments->kind, "what to make")
        ->required()
        ->default_str("")
        ->check(CLI::IsMember(kind_names()));
    verb.add_option("-o,--output", arguments->output, "the model; - is RVM on standard output")
        ->required();
    verb.add_option("--count", arguments->options.count,
                    "about so many parts; 0: as the kind has by itself");
    verb.add_option("--seed", arguments->options.seed, "the same seed makes the same bytes");
    verb.add_option("--extent", arguments->options.extent_m,
                    "side length in metres; 0: as the count needs")
        ->check(CLI::Range(0.0, 1e6));
    verb.add_option("--offset", arguments->offset, "x,y,z in metres: moves everything")
        ->check(check_vector);
    add_reporting(verb, arguments->reporting);
    verb.callback([&run, arguments] { run = [arguments] { return generate_model(*arguments); }; });
}

}  // namespace quartic::cli
