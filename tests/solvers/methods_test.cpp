// Every solver of the table on quartics with clear roots: what even the weakest of them promises.
#include "tests/solvers/quartics.h"

#include <cmath>
#include <string>

namespace quartic {
namespace {

using test::all_of_quartics;
using test::centred;
using test::first_root;
using test::from_factors;
using test::from_roots;
using test::Long;
using test::Roots;

std::string solver_name(const testing::TestParamInfo<int>& info) {
    for (const SolverRow& row : solver_table()) {
        if (row.id == info.param) {
            return std::string(row.name);
        }
    }
    return "unknown";
}

class Method : public testing::TestWithParam<int> {};

// From before all roots, the first one.
template <class Real>
void expect_first(int id, const Roots& chosen, Long error) {
    const Roots roots = centred(chosen);
    const Long width = roots[3] - roots[0];
    const Real tolerance = Real((sizeof(Real) == 4 ? 1e-4L : 1e-8L) * width);
    const auto found = first_root(from_roots<Real>(roots), Real(roots[0] - 0.2L * width),
                                  Real(roots[3] + 0.2L * width), tolerance, id);
    ASSERT_TRUE(found.found) << double(width);
    EXPECT_NEAR(double(found.t), double(roots[0]), double(error * width));
}

TEST_P(Method, finds_the_first_of_four_roots_at_any_scale) {
    for (const Long scale : {1e-4L, 1e-2L, 1.0L, 1e2L, 1e4L}) {
        for (const Roots& roots : {Roots{-2.0L, -1.0L, 1.0L, 2.0L}, Roots{-2.0L, 0.0L, 0.7L, 1.0L},
                                   Roots{-1.0L, -0.9L, 0.9L, 1.0L}}) {
            const Roots scaled{scale * roots[0], scale * roots[1], scale * roots[2],
                               scale * roots[3]};
            expect_first<double>(GetParam(), scaled, 1e-5L);
            expect_first<float>(GetParam(), scaled, 3e-4L);
        }
    }
}

TEST_P(Method, finds_the_first_of_two_roots_beside_a_complex_pair) {
    // (t - 1) (t - 0.2) (t^2 + 1.2 t + 5).
    const auto quartic = from_factors<double>(-1.2L, 0.2L, 5.0L);
    const auto found = first_root(quartic, -2.0, 2.0, 1e-6, GetParam());
    ASSERT_TRUE(found.found);
    EXPECT_NEAR(found.t, 0.2, 1e-5);
}

TEST_P(Method, finds_nothing_where_all_roots_are_complex) {
    for (const Long q : {0.1L, 2.0L, 30.0L}) {
        for (const Long s : {0.2L, 3.0L}) {
            for (const double low : {-10.0, -1.0, -0.3, 0.0, 0.2, 1.0}) {
                const Long p = 0.5L * std::sqrt(std::min(q, s));
                const auto wide = from_factors<double>(p, q, s);
                EXPECT_FALSE(first_root(wide, low, 10.0, 1e-4, GetParam()).found);
                const auto narrow = from_factors<float>(p, q, s);
                EXPECT_FALSE(first_root(narrow, float(low), 10.0f, 1e-3f, GetParam()).found);
            }
        }
    }
}

TEST_P(Method, finds_nothing_in_an_empty_interval) {
    const auto quartic = from_roots<double>(centred({-2.0L, -1.0L, 1.0L, 2.0L}));
    EXPECT_FALSE(first_root(quartic, 0.5, 0.5, 1e-4, GetParam()).found);
    EXPECT_FALSE(first_root(quartic, 3.0, -3.0, 1e-4, GetParam()).found);
}

TEST_P(Method, finds_nothing_beyond_the_interval) {
    const auto quartic = from_roots<double>(centred({-2.0L, -1.0L, 1.0L, 2.0L}));
    EXPECT_FALSE(first_root(quartic, -4.0, -2.1, 1e-4, GetParam()).found);
    EXPECT_FALSE(first_root(quartic, 2.1, 4.0, 1e-4, GetParam()).found);
}

TEST_P(Method, stays_finite_and_inside_the_interval_whatever_the_coefficients) {
    test::Sequence<float> next(1);
    for (int i = 0; i < 60000; ++i) {
        // Some coefficients vanish: no division by them may show.
        const Solver<float>::Polynomial quartic = Solver<float>().polynomial(
            1.0f, 0.0f, i % 3 == 0 ? 0.0f : 4.0f * next(), i % 5 == 0 ? 0.0f : 4.0f * next(),
            i % 7 == 0 ? 0.0f : 4.0f * next());
        const float low = 2.0f * next();
        const float high = low + 2.0f + next();
        const auto root = first_root(quartic, low, high, 1e-3f, GetParam());
        ASSERT_TRUE(std::isfinite(root.t));
        if (root.found) {
            ASSERT_GE(root.t, low - 1e-3f);
            ASSERT_LE(root.t, high + 1e-3f);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Table, Method, testing::ValuesIn(all_of_quartics()), solver_name);

}  // namespace
}  // namespace quartic
