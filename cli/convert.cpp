// The verb convert: a model in another format, chosen by the output's name.
#include "cli/arguments.h"
#include "cli/model.h"
#include "cli/signals.h"
#include "cli/verbs.h"
#include "exporters/save.h"

#include <nlohmann/json.hpp>

#include <memory>

namespace quartic::cli {
namespace {

struct ConvertArguments {
    std::vector<std::string> files;
    std::string output;
    Reporting reporting;
};

// Before the model is read: whether the output can be written at all.
Status check_output(const std::string& path) {
    if (path != "-" && find_exporter(path) == nullptr) {
        return Error{ErrorKind::usage, path,
                     "expected the name of a format that can be written, such as model.rvm; see "
                     "quartic --list-formats"};
    }
    const Result<Output> output = Output::create(path);
    return output ? Status(Done{}) : Status(output.error());
}

ExitCode convert(const ConvertArguments& arguments) {
    const Status writable = check_output(arguments.output);
    if (!writable) {
        return report_error(writable.error());
    }
    const Result<Model> model = load_models(arguments.files, arguments.reporting);
    if (!model) {
        return report_error(model.error());
    }
    if (is_interrupted()) {
        return exit_failed;
    }
    const Status saved = save_model(model.value().scene, arguments.output);
    if (!saved) {
        return report_error(saved.error());
    }
    Findings findings = model.value().scene.findings;
    findings.add_all(export_findings(model.value().scene, arguments.output));
    ExitCode code = exit_ok;
    if (arguments.reporting.json) {
        code = print_json({{"schema", json_schema},
                           {"file", model.value().path},
                           {"output", arguments.output},
                           {"parts", model.value().scene.parts.size()},
                           {"nodes", model.value().scene.nodes.size()},
                           {"load_ms", model.value().load_ms},
                           {"peak_memory_bytes", peak_memory_bytes()},
                           {"findings", findings_as_json(findings)}});
    }
    return worse_of(code, report_findings(model.value().path, findings, arguments.reporting));
}

}  // namespace

void add_convert(CLI::App& program, Run& run) {
    const auto arguments = std::make_shared<ConvertArguments>();
    CLI::App& verb = *program.add_subcommand("convert", "write a model in another format");
    verb.footer(
        "Example: quartic convert plant.rev -o plant.rvm\n"
        "         quartic convert plant.rvm -o plant.pov");
    verb.add_option("IN", arguments->files, "the model; - is standard input")
        ->required()
        ->default_str("");
    verb.add_option("-o,--output", arguments->output, "the result; - is RVM on standard output")
        ->required();
    add_reporting(verb, arguments->reporting);
    verb.callback([&run, arguments] { run = [arguments] { return convert(*arguments); }; });
}

}  // namespace quartic::cli
