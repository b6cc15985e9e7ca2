// The table of solvers.
#include "solvers/solver_table.h"

namespace quartic {
namespace {

constexpr SolverRow rows[] = {
    {1, "convexity_split", "torus cubic quartic",
     "monotone Newton on the intervals between inflections (solvers/convexity_split.glsl)"},
    {2, "newton", "torus",
     "bounded Newton as printed, with its lost hits (de Toledo, Levy, Paul 2007, section 4.4)"},
    {3, "newton_fine", "torus",
     "the same, stopping at a step of 0.00003 radii (de Toledo, Levy, Paul 2007, section 4.4)"},
    {4, "newton_forward", "torus",
     "the same, never turning back before a root (solvers/newton.glsl)"},
    {5, "sturm", "torus cubic quartic",
     "Sturm's sequence, 20 halvings (de Toledo, Levy, Paul 2007, sections 3 and 4.1)"},
    {6, "double_derivative_bisection", "torus",
     "halving by the signs of f and f' (de Toledo, Levy, Paul 2007, section 4.2)"},
    {7, "sphere_tracing", "torus",
     "marching by the distance (Hart 1996; de Toledo, Levy, Paul 2007, section 4.3)"},
    {8, "sphere_tracing_two_ray", "torus",
     "the same with a second start (de Toledo, Levy, Paul 2007, section 4.3)"},
    {9, "analytic", "torus cubic quartic",
     "the closed forms of Cardano, Viete and Ferrari (Abramowitz, Stegun 1964, section 3.8)"},
    {10, "bracketed", "torus cubic quartic",
     "Newton in brackets between turning points (Yuksel 2022, Proc. ACM CGIT 5(3))"},
    {11, "sturm_adaptive", "torus cubic quartic",
     "as sturm, with fewer halvings the farther away (de Toledo, Levy, Paul 2007, section 3)"},
};

// Whether a word is in a list with spaces between.
bool lists(std::string_view list, std::string_view word) {
    while (!list.empty()) {
        const std::size_t end = list.find(' ');
        if (list.substr(0, end) == word) {
            return true;
        }
        list.remove_prefix(end == std::string_view::npos ? list.size() : end + 1);
    }
    return false;
}

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

bool solves(const SolverRow& row, std::string_view name) {
    return lists(row.solves, name);
}

bool has_solvers(std::string_view name) {
    for (const SolverRow& row : rows) {
        if (solves(row, name)) {
            return true;
        }
    }
    return false;
}

int solver_for(std::string_view name, int chosen) {
    if (chosen == solver_none && has_solvers(name)) {
        return chosen;
    }
    for (const SolverRow& row : rows) {
        if (row.id == chosen && solves(row, name)) {
            return chosen;
        }
    }
    return solver_default;
}

}  // namespace quartic
