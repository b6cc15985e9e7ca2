// What a user sees who asks for help, or asks for what there is not.
#include "tests/cli/run_program.h"

#include <gtest/gtest.h>

namespace quartic {
namespace {

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

// One line on standard error, nothing on standard output, exit code 2.
void expect_usage_error(const Answer& run, const std::string& part) {
    EXPECT_EQ(run.code, 2);
    EXPECT_EQ(run.out, "");
    EXPECT_EQ(count_lines(run.err), 1u) << run.err;
    EXPECT_TRUE(run.err.starts_with("quartic: ")) << run.err;
    EXPECT_TRUE(contains(run.err, part)) << run.err;
}

class HelpOfVerb : public testing::TestWithParam<const char*> {};

TEST_P(HelpOfVerb, has_an_example_and_goes_to_standard_output) {
    const std::string verb = GetParam();
    const Answer run = run_quartic({verb, "--help"});
    EXPECT_EQ(run.code, 0);
    EXPECT_EQ(run.err, "");
    EXPECT_TRUE(contains(run.out, "Example: quartic " + verb)) << run.out;
    EXPECT_TRUE(contains(run.out, "--json"));
}

INSTANTIATE_TEST_SUITE_P(Verbs, HelpOfVerb,
                         testing::Values("view", "render", "info", "convert", "check", "bench",
                                         "generate"),
                         [](const auto& verb) { return std::string(verb.param); });

TEST(Usage, help_of_the_program_names_every_verb) {
    const Answer run = run_quartic({"--help"});
    EXPECT_EQ(run.code, 0);
    for (const char* verb : {"view", "render", "info", "convert", "check", "bench", "generate"}) {
        EXPECT_TRUE(contains(run.out, verb)) << verb;
    }
}

TEST(Usage, no_verb_is_an_error) {
    expect_usage_error(run_quartic({}), "--help");
}

TEST(Usage, unknown_verb_is_an_error) {
    expect_usage_error(run_quartic({"rendr", "a.rvm"}), "rendr");
}

// Without care the option's value would become the name of a missing model.
TEST(Usage, mistyped_option_is_named_with_the_one_that_was_meant) {
    expect_usage_error(run_quartic({"render", "--tolerence", "2", "a.rvm", "-o", "a.png"}),
                       "--tolerance?");
}

TEST(Usage, value_out_of_range_is_named) {
    expect_usage_error(run_quartic({"render", "a.rvm", "-o", "a.png", "--size", "0x10"}), "'0x10'");
    expect_usage_error(run_quartic({"check", "a.rvm", "--views", "0"}), "--views");
}

TEST(Usage, unknown_solver_points_to_the_list) {
    expect_usage_error(run_quartic({"render", "a.rvm", "-o", "a.png", "--solver", "magic"}),
                       "--list-solvers");
}

TEST(Usage, missing_output_is_an_error) {
    expect_usage_error(run_quartic({"render", "a.rvm"}), "--output");
}

TEST(Usage, picture_and_json_cannot_share_standard_output) {
    expect_usage_error(run_quartic({"render", "a.rvm", "-o", "-", "--json"}), "standard output");
}

TEST(Usage, version_is_one_line) {
    const Answer run = run_quartic({"--version"});
    EXPECT_EQ(run.code, 0);
    EXPECT_TRUE(run.out.starts_with("quartic ")) << run.out;
    EXPECT_EQ(count_lines(run.out), 1u);
}

}  // namespace
}  // namespace quartic
