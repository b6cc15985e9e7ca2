// Depressed quartics whose roots are chosen first, for the solvers that must not miss one.
#include "tests/solvers/quartics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace quartic {
namespace {

using test::centred;
using test::first_root;
using test::from_factors;
using test::from_roots;
using test::Long;
using test::Roots;

std::vector<int> solvers() {
    return test::ids_of({"convexity_split", "bracketed"});
}

// The first root after low must be found for every low that is not too near to one.
template <class Real>
void expect_first_roots(Roots chosen, Long error, Long clear) {
    const Roots roots = centred(chosen);
    const auto quartic = from_roots<Real>(roots);
    const Long width = roots[3] - roots[0];
    const Long step = sizeof(Real) == 4 ? 1e-4L : 1e-8L;
    for (const int id : solvers()) {
        for (int i = -4; i <= 24; ++i) {
            const Long low = roots[0] + width * Long(i) / 20.0L;
            const Long high = roots[3] + width;
            if (std::any_of(roots.begin(), roots.end(),
                            [&](Long root) { return std::abs(root - low) < clear * width; })) {
                continue;
            }
            const auto next =
                std::find_if(roots.begin(), roots.end(), [&](Long root) { return root > low; });
            const auto found = first_root(quartic, Real(low), Real(high), Real(step * width), id);
            ASSERT_EQ(found.found, next != roots.end())
                << "solver " << id << ", from " << double(low);
            if (found.found) {
                EXPECT_NEAR(double(found.t), double(*next), double(error * width))
                    << "solver " << id;
            }
        }
    }
}

TEST(Quartic, separated_roots_are_found_in_order) {
    expect_first_roots<double>({-2.0L, -1.0L, 1.0L, 2.0L}, 1e-7L, 1e-6L);
    expect_first_roots<double>({-5.0L, 0.0L, 0.3L, 1.0L}, 1e-7L, 1e-6L);
    expect_first_roots<float>({-2.0L, -1.0L, 1.0L, 2.0L}, 1e-5L, 1e-3L);
}

TEST(Quartic, huge_and_tiny_scales_do_not_matter) {
    for (const Long scale : {1e-4L, 1e-2L, 1e2L, 1e4L}) {
        expect_first_roots<double>({-2.0L * scale, -1.0L * scale, 0.5L * scale, 2.0L * scale},
                                   1e-7L, 1e-6L);
        expect_first_roots<float>({-2.0L * scale, -1.0L * scale, 0.5L * scale, 2.0L * scale}, 1e-5L,
                                  1e-3L);
    }
}

TEST(Quartic, clustered_roots_are_told_apart) {
    expect_first_roots<double>({0.0L, 1e-3L, 1.0L, 1.001L}, 1e-7L, 1e-5L);
    expect_first_roots<double>({-1.0L, -0.999L, -0.998L, 3.0L}, 1e-6L, 1e-4L);
}

TEST(Quartic, complex_pairs_are_no_roots) {
    const auto quartic = from_factors<double>(0.5L, 2.0L, 3.0L);
    for (const int id : solvers()) {
        for (const double low : {-10.0, -1.0, -0.3, 0.0, 0.2, 1.0}) {
            EXPECT_FALSE(first_root(quartic, low, 10.0, 1e-4, id).found);
        }
    }
}

TEST(Quartic, two_real_roots_beside_a_complex_pair) {
    // t^2 - 1.2 t + 0.2 = (t - 1) (t - 0.2), t^2 + 1.2 t + 5 has no real root.
    const auto quartic = from_factors<double>(-1.2L, 0.2L, 5.0L);
    for (const int id : solvers()) {
        EXPECT_NEAR(first_root(quartic, -10.0, 10.0, 1e-5, id).t, 0.2, 1e-7);
        EXPECT_NEAR(first_root(quartic, 0.5, 10.0, 1e-5, id).t, 1.0, 1e-7);
        EXPECT_FALSE(first_root(quartic, 1.5, 10.0, 1e-5, id).found);
    }
}

TEST(Quartic, a_double_root_is_found_once_or_is_a_tie) {
    const Roots roots = centred({-1.0L, 0.3L, 0.3L, 2.0L});
    const auto quartic = from_roots<double>(roots);
    for (const int id : solvers()) {
        const auto found =
            first_root(quartic, double(roots[0]) + 0.1, double(roots[3]) + 1.0, 1e-6, id);
        ASSERT_TRUE(found.found);
        const bool at_double = std::abs(found.t - double(roots[1])) < 1e-5;
        const bool at_next = std::abs(found.t - double(roots[3])) < 1e-7;
        EXPECT_TRUE(at_double || at_next) << found.t;
    }
}

TEST(Quartic, a_double_root_in_float_is_found_once_or_is_a_tie) {
    for (const Long scale : {1e-3L, 1.0L, 1e3L}) {
        const Roots roots = centred({-1.0L * scale, 0.3L * scale, 0.3L * scale, 2.0L * scale});
        const auto quartic = from_roots<float>(roots);
        for (const int id : solvers()) {
            const auto found = first_root(quartic, float(roots[0] + 0.1L * scale),
                                          float(roots[3] + scale), float(1e-3L * scale), id);
            ASSERT_TRUE(found.found);
            const Long from_double = std::abs(Long(found.t) - roots[1]);
            const Long from_next = std::abs(Long(found.t) - roots[3]);
            EXPECT_TRUE(from_double < 5e-3L * scale || from_next < 1e-5L * scale) << found.t;
        }
    }
}

TEST(Quartic, random_roots_are_found_from_anywhere) {
    test::Sequence<Long> next(3);
    for (int i = 0; i < 2000; ++i) {
        expect_first_roots<double>({next(), next(), next(), next()}, 1e-6L, 1e-4L);
    }
}

TEST(Quartic, a_root_never_lies_outside_the_interval) {
    test::Sequence<float> next(1);
    for (int i = 0; i < 100000; ++i) {
        const Solver<float>::Polynomial quartic =
            Solver<float>().polynomial(1.0f, 0.0f, 4.0f * next(), 4.0f * next(), 4.0f * next());
        const float low = 2.0f * next();
        const float high = low + 2.0f + next();
        for (const int id : solvers()) {
            const auto root = first_root(quartic, low, high, 1e-3f, id);
            if (root.found) {
                ASSERT_GE(root.t, low - 1e-3f);
                ASSERT_LE(root.t, high + 1e-3f);
            }
        }
    }
}

TEST(Quartic, an_empty_interval_has_no_root) {
    const auto quartic = from_roots<double>(centred({-2.0L, -1.0L, 1.0L, 2.0L}));
    for (const int id : solvers()) {
        EXPECT_FALSE(first_root(quartic, 0.5, 0.5, 1e-4, id).found);
        EXPECT_FALSE(first_root(quartic, 3.0, -3.0, 1e-4, id).found);
    }
}

}  // namespace
}  // namespace quartic
