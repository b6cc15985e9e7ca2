// The table of solvers.
#include "solvers/solver_table.h"

namespace quartic {
namespace {

constexpr SolverRow rows[] = {
    {1, "convexity_split", "torus",
     "monotone Newton on the intervals between inflections (solvers/convexity_split.glsl)"},
};

}  // namespace

std::span<const SolverRow> solver_table() {
    return rows;
}

const SolverRow* find_solver(std::string_view name) {
    for (const SolverRow& row : rows) {
        if (row.name == name) {
            return &row;
        }
    }
    return nullptr;
}

}  // namespace quartic
