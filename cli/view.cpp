// The verb view: opens a window.
#include "cli/arguments.h"
#include "cli/verbs.h"

#ifdef QUARTIC_VIEWER
#include "viewer/viewer.h"
#endif

#include <memory>

namespace quartic::cli {
namespace {

struct ViewArguments {
    std::vector<std::string> files;
    std::string solver;
    std::string camera = "fit";
    bool software = false;
    Reporting reporting;
};

#ifdef QUARTIC_VIEWER

ExitCode view(const ViewArguments& arguments) {
    const ViewerOptions options{arguments.files, solver_number(arguments.solver), arguments.camera,
                                arguments.software};
    const Result<int> code = run_viewer(options);
    return code ? code.value() : report_error(code.error());
}

#else

ExitCode view(const ViewArguments&) {
    return report_usage("view", "this program was built without its window (QUARTIC_VIEWER=OFF)");
}

#endif

}  // namespace

void add_view(CLI::App& program, Run& run) {
    const auto arguments = std::make_shared<ViewArguments>();
    CLI::App& verb = *program.add_subcommand("view", "open a window");
    verb.footer("Example: quartic view plant.rvm");
    verb.add_option("FILE", arguments->files, "models")->default_str("");
    verb.add_option("--solver", arguments->solver, "see --list-solvers")->check(check_solver);
    verb.add_option("--camera", arguments->camera, "where to start, as for render");
    verb.add_flag("--software", arguments->software, "Mesa's software OpenGL");
    add_reporting(verb, arguments->reporting);
    verb.callback([&run, arguments] { run = [arguments] { return view(*arguments); }; });
}

}  // namespace quartic::cli
