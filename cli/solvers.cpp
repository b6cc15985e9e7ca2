// Reads and applies the options that choose solvers.
#include "cli/solvers.h"

#include "cli/arguments.h"
#include "scene/joints.h"

#include <regex>

namespace quartic::cli {
namespace {

// The last = parts them: a solver's name has none.
std::string pattern_of(const std::string& rule) {
    return rule.substr(0, rule.rfind('='));
}

std::string name_of(const std::string& rule) {
    return rule.substr(rule.rfind('=') + 1);
}

std::string check_rule(const std::string& rule) {
    if (rule.find('=') == std::string::npos) {
        return "expected REGEX=NAME such as colour.*=newton, found '" + rule + "'";
    }
    try {
        const std::regex pattern(pattern_of(rule));
    } catch (const std::regex_error&) {
        return "expected a regular expression before the =, found '" + pattern_of(rule) + "'";
    }
    return check_solver(name_of(rule));
}

}  // namespace

void add_solvers(CLI::App& verb, SolverArguments& arguments) {
    verb.add_option("--solver", arguments.everywhere, "for everything; see --list-solvers")
        ->check(check_solver);
    verb.add_option("--material-solver", arguments.by_materials,
                    "REGEX=NAME: for materials whose name matches; may be repeated")
        ->allow_extra_args(false)
        ->check(check_rule);
}

void prepare(const SolverArguments& arguments, Scene& scene) {
    for (const std::string& rule : arguments.by_materials) {
        const std::regex pattern(pattern_of(rule));
        for (Material& material : scene.materials) {
            if (std::regex_search(material.name, pattern)) {
                material.solver = solver_number(name_of(rule));
            }
        }
    }
    find_joints(scene);
}

}  // namespace quartic::cli
