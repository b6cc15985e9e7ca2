// Signals, time limits and outputs that take no more.
#include "tests/cli/run_program.h"

#include <gtest/gtest.h>

#include <signal.h>

namespace quartic {
namespace {

TEST(Interruption, sigterm_ends_with_143_and_leaves_the_old_output) {
    const TemporaryFolder folder;
    const std::string output = folder.write("old.png", "old");
    WaitingProgram program({"render", "-", "-o", output});
    program.send(SIGTERM);
    EXPECT_EQ(program.wait_for_code(), 143);
    EXPECT_EQ(read_bytes(output), "old");
    EXPECT_EQ(folder.file_count(), 1u);
}

TEST(Interruption, sigint_ends_with_130) {
    WaitingProgram program({"info", "-"});
    program.send(SIGINT);
    EXPECT_EQ(program.wait_for_code(), 130);
}

TEST(Interruption, time_limit_ends_with_124) {
    WaitingProgram program({"info", "-", "--time-limit", "1"});
    EXPECT_EQ(program.wait_for_code(), 124);
}

}  // namespace
}  // namespace quartic
