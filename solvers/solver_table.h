// Names of the solvers and what each can solve; their numbers are in first_root.glsl.
#pragma once

#include <span>
#include <string_view>

namespace quartic {

struct SolverRow {
    int id;
    std::string_view name;
    std::string_view solves;  // "torus", "torus cubic quartic", ...
    std::string_view source;  // the paper, or where the recipe is written down
};

constexpr int solver_default = 1;
constexpr int solver_none = -1;  // as in first_root.glsl: all but the solving, for benchmarks

std::span<const SolverRow> solver_table();
const SolverRow* find_solver(std::string_view name);
// Whether a solver works on what bears this name.
bool solves(const SolverRow& row, std::string_view name);
// Whether any solver works on what bears this name: the others are drawn alike whatever is chosen.
bool has_solvers(std::string_view name);
// The solver chosen for what bears this name if it works on it, else the default. solver_none works
// on all that have solvers.
int solver_for(std::string_view name, int chosen);

}  // namespace quartic
