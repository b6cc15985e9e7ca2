// Holds the tree to its rules.
#include "tests/tidy/rules.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>

namespace quartic::tidy {

// Found by GoogleTest, which names the parameter of a failed test.
void PrintTo(const Rule& rule, std::ostream* stream) {
    *stream << rule.name;
}

namespace {

const Tree& own_tree() {
    static const Tree tree = read_tree(QUARTIC_SOURCE_DIR);
    return tree;
}

bool is_excepted(std::string_view rule, std::string_view path) {
    return std::any_of(exceptions().begin(), exceptions().end(), [&](const Exception& exception) {
        return exception.rule == rule && exception.path == path;
    });
}

class Tidy : public testing::TestWithParam<Rule> {};

TEST_P(Tidy, holds_for_the_tree) {
    ASSERT_TRUE(own_tree().contains("tests/tidy/tidy_test.cpp"))
        << "no tree at " QUARTIC_SOURCE_DIR;
    for (const Offence& offence : GetParam().find(own_tree())) {
        if (!is_excepted(GetParam().name, offence.path)) {
            ADD_FAILURE() << offence.path << ":" << offence.line << ": " << offence.what;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Rules, Tidy, testing::ValuesIn(rules().begin(), rules().end()),
                         [](const testing::TestParamInfo<Rule>& row) {
                             return std::string(row.param.name);
                         });

TEST(Exceptions, are_all_needed) {
    for (const Exception& exception : exceptions()) {
        const auto rule = std::find_if(rules().begin(), rules().end(),
                                       [&](const Rule& row) { return row.name == exception.rule; });
        ASSERT_NE(rule, rules().end()) << exception.rule;
        const Offences offences = rule->find(own_tree());
        EXPECT_TRUE(
            std::any_of(offences.begin(), offences.end(),
                        [&](const Offence& offence) { return offence.path == exception.path; }))
            << exception.path << " no longer offends against " << exception.rule;
    }
}

}  // namespace
}  // namespace quartic::tidy
