// Which solver draws what: --solver for everything, --material-solver for some materials.
#pragma once

#include "scene/scene.h"

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace quartic::cli {

struct SolverArguments {
    std::string everywhere;                 // a name, or empty: the materials' own
    std::vector<std::string> by_materials;  // "REGEX=NAME"; the last that matches a name counts
};

void add_solvers(CLI::App& verb, SolverArguments& arguments);

// What a scene needs before it is drawn: --material-solver in its materials, and its joints.
void prepare(const SolverArguments& arguments, Scene& scene);

}  // namespace quartic::cli
