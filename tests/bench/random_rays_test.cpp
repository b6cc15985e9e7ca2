// The short form of the benchmark rays: what the default solver promises, on every kind of ray.
#include "bench/random_rays.h"

#include "solvers/solver_table.h"

#include <gtest/gtest.h>

#include <cmath>

namespace quartic {
namespace {

RayTrial trial_of(RayKind kind, double ratio, bool arcs, int solver = solver_default) {
    RayTrialOptions options;
    options.rays = 40'000;
    options.kind = kind;
    options.ratio = ratio;
    options.arcs = arcs;
    options.solver = solver;
    return try_rays(options);
}

class RandomRays : public ::testing::TestWithParam<int> {};

std::string kind_name(const ::testing::TestParamInfo<int>& info) {
    return std::string(name(static_cast<RayKind>(info.param)));
}

void expect_right(const RayTrial& trial) {
    EXPECT_EQ(trial.rays, 40'000u);
    EXPECT_GT(trial.hits, 1'000u);
    EXPECT_EQ(trial.missed_hard, 0u);
    EXPECT_EQ(trial.false_hard, 0u);
    EXPECT_EQ(trial.elsewhere_hard, 0u);
}

TEST_P(RandomRays, rings_and_spindles_have_no_hard_wrong_ray) {
    expect_right(trial_of(static_cast<RayKind>(GetParam()), 0.0, false));
}

TEST_P(RandomRays, elbows_have_no_hard_wrong_ray) {
    expect_right(trial_of(static_cast<RayKind>(GetParam()), 0.0, true));
}

INSTANTIATE_TEST_SUITE_P(Kinds, RandomRays, ::testing::Range(0, int(ray_kind_count)), kind_name);

TEST(RandomRaysOf, the_test_ring_are_as_exact_as_floats_allow) {
    const RayTrial trial = trial_of(RayKind::near, 3.0 / 7.0, false);
    expect_right(trial);
    EXPECT_LE(trial.errors.quantile(0.5), 2e-7);
    EXPECT_LE(trial.errors.quantile(0.9999), 2e-5);
}

TEST(RandomRaysOf, newton_as_printed_are_sometimes_lost) {
    const RayTrial trial = trial_of(RayKind::near, 3.0 / 7.0, false, find_solver("newton")->id);
    EXPECT_GT(trial.missed_hard, 0u);
}

TEST(RandomRaysOf, one_trial_are_those_of_the_next) {
    const RayTrial first = trial_of(RayKind::grazing, 0.0, true);
    const RayTrial second = trial_of(RayKind::grazing, 0.0, true);
    EXPECT_EQ(first.hits, second.hits);
    EXPECT_EQ(first.steps, second.steps);
    EXPECT_EQ(first.errors.most(), second.errors.most());
}

TEST(ErrorHistogram, quantiles_are_right_to_a_step) {
    ErrorHistogram histogram;
    for (int i = 1; i <= 1000; ++i) {
        histogram.add(1e-6 * i);
    }
    EXPECT_NEAR(histogram.quantile(0.5), 500e-6, 0.08 * 500e-6);
    EXPECT_NEAR(histogram.quantile(0.9), 900e-6, 0.08 * 900e-6);
    EXPECT_EQ(histogram.most(), 1000e-6);
    EXPECT_EQ(ErrorHistogram().quantile(0.5), 0.0);
}

}  // namespace
}  // namespace quartic
