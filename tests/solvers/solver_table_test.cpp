// The table of solvers: names are found, numbers are stable.
#include "solvers/solver_table.h"

#include <gtest/gtest.h>

#include <set>
#include <utility>

namespace quartic {
namespace {

TEST(SolverTable, names_and_numbers_are_unique) {
    std::set<int> ids;
    std::set<std::string_view> names;
    for (const SolverRow& row : solver_table()) {
        EXPECT_TRUE(ids.insert(row.id).second);
        EXPECT_TRUE(names.insert(row.name).second);
        EXPECT_FALSE(row.solves.empty());
        EXPECT_EQ(find_solver(row.name), &row);
    }
    EXPECT_TRUE(ids.contains(solver_default));
}

TEST(SolverTable, an_unknown_name_is_none) {
    EXPECT_EQ(find_solver("no_such_solver"), nullptr);
    EXPECT_EQ(find_solver(""), nullptr);
}

TEST(SolverTable, stored_numbers_never_change) {
    const std::pair<const char*, int> stored[] = {
        {"convexity_split", 1}, {"newton", 2},
        {"newton_fine", 3},     {"newton_forward", 4},
        {"sturm", 5},           {"double_derivative_bisection", 6},
        {"sphere_tracing", 7},  {"sphere_tracing_two_ray", 8},
        {"analytic", 9},        {"bracketed", 10},
        {"sturm_adaptive", 11}};
    for (const auto& [name, id] : stored) {
        ASSERT_NE(find_solver(name), nullptr) << name;
        EXPECT_EQ(find_solver(name)->id, id) << name;
    }
}

TEST(SolverTable, only_what_a_row_names_has_solvers) {
    EXPECT_TRUE(has_solvers("torus"));
    EXPECT_FALSE(has_solvers("cylinder"));
    EXPECT_FALSE(has_solvers("tor"));
    EXPECT_FALSE(has_solvers(""));
}

TEST(SolverTable, what_a_solver_does_not_solve_is_left_to_the_default) {
    EXPECT_EQ(solver_for("torus", find_solver("newton")->id), find_solver("newton")->id);
    EXPECT_EQ(solver_for("quartic", find_solver("sturm")->id), find_solver("sturm")->id);
    EXPECT_EQ(solver_for("quartic", find_solver("sphere_tracing")->id), solver_default);
    EXPECT_EQ(solver_for("cylinder", find_solver("newton")->id), solver_default);
    EXPECT_EQ(solver_for("torus", 0), solver_default);
    EXPECT_EQ(solver_for("torus", solver_none), solver_none);
    EXPECT_EQ(solver_for("cylinder", solver_none), solver_default);
}

}  // namespace
}  // namespace quartic
