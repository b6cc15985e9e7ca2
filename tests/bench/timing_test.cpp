// Interleaved rounds under a clock that the test turns.
#include "bench/timing.h"

#include <gtest/gtest.h>

#include <string>

namespace quartic {
namespace {

// A machine on which a run takes as long as its case says, times how slow the machine is by then.
class FakeMachine {
public:
    TimedCase add(const std::string& name, double seconds) {
        return {name,
                [this, name] {
                    log += name + "-";
                    return Status(Done{});
                },
                [this, name, seconds] {
                    log += name;
                    now += seconds * slowness;
                    slowness *= drift;
                    return Status(Done{});
                }};
    }
    TimingOptions options(int rounds) {
        TimingOptions options;
        options.rounds = rounds;
        options.clock = [this] { return now; };
        return options;
    }

    std::string log;
    double now = 100.0;
    double slowness = 1.0;
    double drift = 1.0;
};

TEST(Timing, rounds_go_forwards_and_backwards_and_warm_up) {
    FakeMachine machine;
    const TimedCase cases[] = {machine.add("a", 1.0), machine.add("b", 2.0)};
    const auto timed = time_interleaved(cases, machine.options(3));
    ASSERT_TRUE(timed);
    // Prepare, warm up, measure.
    EXPECT_EQ(machine.log, "a-aab-bbb-bba-aaa-aab-bb");
    EXPECT_EQ(timed.value(), (std::vector<Rounds>{{1.0, 1.0, 1.0}, {2.0, 2.0, 2.0}}));
}

TEST(Timing, short_runs_are_repeated_until_the_batch_is_long) {
    FakeMachine machine;
    const TimedCase cases[] = {machine.add("a", 0.25), machine.add("b", 2.0)};
    TimingOptions options = machine.options(1);
    options.batch_s = 1.0;
    const auto timed = time_interleaved(cases, options);
    ASSERT_TRUE(timed);
    EXPECT_EQ(machine.log, "a-aaaaab-bb");
    EXPECT_DOUBLE_EQ(timed.value()[0][0], 0.25);
    EXPECT_DOUBLE_EQ(timed.value()[1][0], 2.0);
}

// After 40 rounds the machine is over four times as slow; the ratio does not notice.
TEST(Timing, ratios_survive_a_machine_that_gets_slower) {
    FakeMachine machine;
    machine.drift = 1.01;
    const TimedCase cases[] = {machine.add("a", 1.0), machine.add("b", 3.0)};
    const auto timed = time_interleaved(cases, machine.options(40));
    ASSERT_TRUE(timed);
    EXPECT_GT(timed.value()[0].back(), 4.0 * timed.value()[0].front());
    EXPECT_NEAR(median_ratio(timed.value()[1], timed.value()[0]), 3.0, 0.01);
}

TEST(Timing, stops_where_it_is_told_to) {
    FakeMachine machine;
    const TimedCase cases[] = {machine.add("a", 1.0)};
    TimingOptions options = machine.options(10);
    options.is_stopped = [&] { return machine.now > 103.0; };
    const auto timed = time_interleaved(cases, options);
    ASSERT_FALSE(timed);
    EXPECT_EQ(timed.error().kind, ErrorKind::interrupted);
    EXPECT_EQ(machine.log, "a-aaa-aa");
}

TEST(Timing, failure_of_a_run_is_passed_on) {
    const TimedCase cases[] = {{"a", [] { return Status(Done{}); },
                                [] {
                                    return Status(Error{ErrorKind::no_opengl, "", "lost"});
                                }}};
    const auto timed = time_interleaved(cases, {});
    ASSERT_FALSE(timed);
    EXPECT_EQ(timed.error().message, "lost");
}

TEST(Timing, medians_and_sums) {
    EXPECT_DOUBLE_EQ(median({}), 0.0);
    EXPECT_DOUBLE_EQ(median({5.0, 1.0, 3.0}), 3.0);
    EXPECT_DOUBLE_EQ(median({4.0, 1.0, 3.0, 2.0}), 2.5);
    const Rounds cases[] = {{1.0, 2.0}, {10.0, 20.0}};
    EXPECT_EQ(sum_of(cases), (Rounds{11.0, 22.0}));
}

TEST(Timing, ratio_is_the_median_of_ratios_not_the_ratio_of_medians) {
    EXPECT_DOUBLE_EQ(median_ratio({1.0, 8.0, 3.0}, {1.0, 2.0, 1.0}), 3.0);
}

TEST(Timing, what_is_alike_is_taken_off_before_the_ratio) {
    EXPECT_DOUBLE_EQ(median_ratio({3.0, 5.0}, {2.0, 3.0}, {1.0, 1.0}, {1.0, 1.0}), 2.0);
    // Rounds in which nothing is left do not count.
    EXPECT_DOUBLE_EQ(median_ratio({3.0, 5.0}, {1.0, 3.0}, {1.0, 1.0}, {1.0, 1.0}), 2.0);
    EXPECT_DOUBLE_EQ(median_ratio({3.0}, {1.0}, {1.0}, {1.0}), 0.0);
}

TEST(Crossover, lies_between_two_counts_on_a_straight_line_in_logarithms) {
    // Twice as slow at 1, twice as fast at 16: even at 4.
    const auto found = crossover({1.0, 16.0}, {2.0, 4.0}, {1.0, 8.0});
    ASSERT_TRUE(found);
    EXPECT_NEAR(*found, 4.0, 1e-12);
}

TEST(Crossover, first_count_where_it_always_leads_and_nothing_where_it_never_does) {
    EXPECT_EQ(crossover({1.0, 4.0}, {1.0, 1.0}, {2.0, 2.0}), 1.0);
    EXPECT_EQ(crossover({1.0, 4.0}, {2.0, 2.0}, {1.0, 1.0}), std::nullopt);
}

TEST(Crossover, lead_that_is_lost_again_does_not_count) {
    EXPECT_EQ(crossover({1.0, 4.0, 16.0}, {1.0, 1.0, 3.0}, {2.0, 2.0, 2.0}), std::nullopt);
}

}  // namespace
}  // namespace quartic
