// The program quartic: finds the verb, runs it, and turns what went wrong into one line.
#include "cli/arguments.h"
#include "cli/signals.h"
#include "cli/verbs.h"

namespace quartic::cli {
namespace {

// CLI11's own messages may have several lines and end with hints of their own.
ExitCode report_parse_error(const CLI::App& program, const CLI::ParseError& error) {
    const auto chosen = program.get_subcommands();
    const std::string verb = chosen.empty() ? "" : chosen.front()->get_name();
    const std::string hint = verb.empty() ? "quartic --help" : "quartic " + verb + " --help";
    return report_usage(verb, std::string(error.what()) + "; see " + hint);
}

ExitCode run_program(int count, char** arguments) {
    CLI::App program{"Views, measures and checks plant models as exact surfaces.", "quartic"};
    program.option_defaults()->always_capture_default();
    Run run;
    add_view(program, run);
    add_render(program, run);
    add_info(program, run);
    add_convert(program, run);
    add_check(program, run);
    add_bench(program, run);
    add_generate(program, run);
    add_lists(program, run);
    program.footer("Example: quartic render plant.rvm -o plant.png --camera iso");

    const std::string unknown = find_unknown_word(program, count, arguments);
    if (!unknown.empty()) {
        return report_usage({}, unknown + "; see quartic --help");
    }
    try {
        program.parse(count, arguments);
    } catch (const CLI::CallForHelp&) {
        return print_text(program.help());  // of the verb, if there is one
    } catch (const CLI::ParseError& error) {
        return report_parse_error(program, error);
    }
    return run ? run() : report_usage({}, "expected a verb; see quartic --help");
}

}  // namespace
}  // namespace quartic::cli

int main(int argc, char** argv) {
    quartic::cli::watch_signals();
    return quartic::cli::final_code(quartic::cli::run_program(argc, argv));
}
