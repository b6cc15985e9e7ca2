// Quadratics whose roots are chosen first, their coefficients calculated in long double.
#include "solvers/solver.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace quartic {
namespace {

using Long = long double;

// a (t - low) (t - high) as a t^2 + 2 b t + c.
template <class Real>
void expect_roots(Long a, Long low, Long high, Real relative_error) {
    Solver<Real> solver;
    const Long b = -0.5L * a * (low + high);
    const Long c = a * low * high;
    const Long discriminant = 0.25L * a * a * (high - low) * (high - low);
    const typename Solver<Real>::Roots2 roots =
        solver.solve_quadratic(Real(a), Real(b), Real(c), Real(discriminant));
    const Real scale = Real(std::max(std::abs(low), std::abs(high)));
    EXPECT_NEAR(roots.low, Real(low),
                relative_error * std::abs(Real(low)) + relative_error * scale);
    EXPECT_NEAR(roots.high, Real(high),
                relative_error * std::abs(Real(high)) + relative_error * scale);
}

TEST(Quadratic, separated_roots_of_all_signs_and_scales) {
    for (const Long a : {1.0L, -1.0L, 1e-6L, -1e6L}) {
        for (const Long scale : {1e-6L, 1.0L, 1e6L}) {
            for (const Long low : {-3.0L, -1.0L, -1e-3L, 0.0L, 0.5L}) {
                for (const Long width : {1e-2L, 1.0L, 100.0L}) {
                    expect_roots<double>(a, scale * low, scale * (low + width), 1e-14);
                    expect_roots<float>(a, scale * low, scale * (low + width), 1e-6f);
                }
            }
        }
    }
}

TEST(Quadratic, a_small_root_beside_a_huge_one_keeps_its_digits) {
    Solver<double> solver;
    const Long low = 1e-9L;
    const Long high = 1e9L;
    const auto roots = solver.solve_quadratic(1.0, double(-0.5L * (low + high)), double(low * high),
                                              double(0.25L * (high - low) * (high - low)));
    EXPECT_NEAR(roots.low / 1e-9, 1.0, 1e-14);
    EXPECT_NEAR(roots.high / 1e9, 1.0, 1e-14);
}

TEST(Quadratic, a_double_root_is_found_twice) {
    for (const Long root : {-7.0L, -1e-5L, 1e-5L, 12345.0L}) {
        expect_roots<double>(2.0L, root, root, 1e-15);
        expect_roots<float>(-2.0L, root, root, 1e-6f);
    }
}

TEST(Quadratic, a_linear_equation_has_one_root_at_infinity) {
    Solver<double> solver;
    const auto rising = solver.solve_quadratic(0.0, 1.0, -4.0, 1.0);  // 2 t - 4
    EXPECT_EQ(rising.low, -1e18);
    EXPECT_DOUBLE_EQ(rising.high, 2.0);
    const auto falling = solver.solve_quadratic(0.0, -1.0, -4.0, 1.0);  // -2 t - 4
    EXPECT_DOUBLE_EQ(falling.low, -2.0);
    EXPECT_EQ(falling.high, 1e18);
}

TEST(Quadratic, roots_are_finite_and_in_order_whatever_the_coefficients) {
    Solver<float> solver;
    for (const float a : {0.0f, 1e-30f, -1e-30f, 1e-3f, -1.0f, 1e10f}) {
        for (const float b : {0.0f, 1e-20f, -1e-20f, 1.0f, -1e6f}) {
            for (const float c : {0.0f, 1e-20f, -1.0f, 1e6f}) {
                const auto roots = solver.solve_quadratic(a, b, c, std::max(0.0f, b * b - a * c));
                EXPECT_TRUE(std::isfinite(roots.low)) << a << ' ' << b << ' ' << c;
                EXPECT_TRUE(std::isfinite(roots.high)) << a << ' ' << b << ' ' << c;
                EXPECT_LE(roots.low, roots.high);
            }
        }
    }
}

}  // namespace
}  // namespace quartic
