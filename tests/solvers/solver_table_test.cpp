// The table of solvers: names are found, numbers are stable.
#include "solvers/solver_table.h"

#include <gtest/gtest.h>

#include <set>

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
    ASSERT_NE(find_solver("convexity_split"), nullptr);
    EXPECT_EQ(find_solver("convexity_split")->id, 1);
}

}  // namespace
}  // namespace quartic
