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
constexpr int solver_none = -1;  // no row: everything but the solving, to see what that costs

std::span<const SolverRow> solver_table();
const SolverRow* find_solver(std::string_view name);
// Whether a solver works on what bears this name.
bool solves(const SolverRow& row, std::string_view name);
// Whether any solver works on what bears this name: the others are drawn alike whatever is chosen.
bool has_solvers(std::string_view name);

}  // namespace quartic
