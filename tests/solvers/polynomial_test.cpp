// General cubics and quartics, with all their terms, whose roots are chosen before their
// coefficients.
#include "tests/solvers/quartics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace quartic {
namespace {

using test::ids_of;
using test::Long;

// lead (t - r_0) (t - r_1) ... of three or four roots.
template <class Real>
typename Solver<Real>::Polynomial with_roots(Long lead, const std::vector<Long>& roots) {
    std::vector<Long> c{lead};
    for (const Long root : roots) {
        c.push_back(0.0L);
        for (std::size_t i = c.size() - 1; i > 0; --i) {
            c[i] -= root * c[i - 1];
        }
    }
    const Long a4 = roots.size() == 4 ? c[0] : 0.0L;
    const std::size_t cubic = roots.size() == 4 ? 1 : 0;
    return Solver<Real>().polynomial(Real(a4), Real(c[cubic]), Real(c[cubic + 1]),
                                     Real(c[cubic + 2]), Real(c[cubic + 3]));
}

struct Case {
    std::vector<Long> roots;  // ascending
    Long first;               // the root that is expected
    Long error;               // that a float may have, of the scale; a double a thousandth of it
};

const std::vector<Case>& cases() {
    static const std::vector<Case> all = {
        {{-0.7L, -0.1L, 0.4L, 0.9L}, -0.7L, 1e-5L},
        {{-0.9L, 0.1L, 0.5L}, -0.9L, 1e-5L},
        {{-0.2L, 0.3L, 0.5L}, -0.2L, 1e-5L},
        {{0.1L, 0.11L, 0.9L, 0.95L}, 0.1L, 1e-3L},    // clustered
        {{-0.5L, -0.49L, 0.8L}, -0.5L, 1e-3L},        // clustered
        {{-0.6L, 0.2L, 0.2L, 0.9L}, -0.6L, 1e-4L},    // a double root behind
        {{-0.6L, 0.3L, 0.3L}, -0.6L, 1e-4L},          // a double root behind
        {{0.2L, 0.2L, 0.2L}, 0.2L, 2e-2L},            // triple
        {{-0.4L, -0.4L, -0.4L, 0.7L}, -0.4L, 2e-2L},  // triple
    };
    return all;
}

template <class Real>
void expect_first_roots(Long error_scale) {
    for (const Long scale : {1e-3L, 1.0L, 1e3L}) {
        for (const Long lead : {1.0L, -1.0L, 0.02L, -50.0L}) {
            for (const Case& one : cases()) {
                std::vector<Long> roots = one.roots;
                for (Long& root : roots) {
                    root *= scale;
                }
                const auto f = with_roots<Real>(lead, roots);
                for (const int id : ids_of({"convexity_split", "bracketed", "sturm", "analytic"})) {
                    const auto found =
                        test::first_root(f, Real(-scale), Real(scale), Real(1e-5L * scale), id);
                    ASSERT_TRUE(found.found) << "solver " << id << ", first " << double(one.first)
                                             << ", lead " << double(lead);
                    EXPECT_NEAR(double(found.t / Real(scale)), double(one.first),
                                double(one.error * error_scale))
                        << "solver " << id << ", roots " << roots.size() << ", lead "
                        << double(lead) << ", scale " << double(scale);
                }
            }
        }
    }
}

TEST(Polynomial, first_roots_in_float_whatever_the_scale_and_the_leading_sign) {
    expect_first_roots<float>(1.0L);
}

TEST(Polynomial, first_roots_in_double_whatever_the_scale_and_the_leading_sign) {
    expect_first_roots<double>(0.2L);
}

TEST(Polynomial, a_double_root_is_found_or_passed_but_nothing_else_is_found) {
    for (const Long scale : {1e-3L, 1.0L, 1e3L}) {
        const std::vector<Long> roots{-0.3L * scale, -0.3L * scale, 0.6L * scale};
        const auto f = with_roots<float>(1.0L, roots);
        for (const int id : ids_of({"convexity_split", "bracketed", "sturm", "analytic"})) {
            const auto found =
                test::first_root(f, float(-scale), float(scale), float(1e-5L * scale), id);
            ASSERT_TRUE(found.found) << id;
            const Long t = Long(found.t) / scale;
            EXPECT_TRUE(std::abs(t + 0.3L) < 5e-3L || std::abs(t - 0.6L) < 1e-4L)
                << id << ": " << double(t);
        }
    }
}

TEST(Polynomial, without_real_roots_nothing_is_found) {
    // (t^2 + 0.2 t + 0.5) (t^2 - 0.6 t + 0.3): no inflection decides alone.
    const auto quartic = Solver<float>().polynomial(1.0f, -0.4f, 0.68f, -0.24f, 0.15f);
    // Beyond the only root of (t - 2) (t^2 + 0.3).
    const auto cubic = Solver<float>().polynomial(0.0f, 1.0f, -2.0f, 0.3f, -0.6f);
    for (const int id : ids_of({"convexity_split", "bracketed", "sturm", "analytic"})) {
        EXPECT_FALSE(test::first_root(quartic, -1.0f, 1.0f, 1e-5f, id).found) << id;
        EXPECT_FALSE(test::first_root(cubic, -1.0f, 1.0f, 1e-5f, id).found) << id;
    }
}

TEST(Polynomial, quadratics_and_lines_are_cubics_without_a_leading_term) {
    const auto parabola = Solver<double>().polynomial(0.0, 0.0, 1.0, 0.1, -0.2);  // 0.4, -0.5
    const auto line = Solver<double>().polynomial(0.0, 0.0, 0.0, 2.0, -1.0);
    for (const int id : ids_of({"convexity_split", "bracketed"})) {
        EXPECT_NEAR(test::first_root(parabola, -1.0, 1.0, 1e-6, id).t, -0.5, 1e-6) << id;
        EXPECT_NEAR(test::first_root(parabola, 0.0, 1.0, 1e-6, id).t, 0.4, 1e-6) << id;
        EXPECT_NEAR(test::first_root(line, -1.0, 1.0, 1e-6, id).t, 0.5, 1e-6) << id;
    }
}

TEST(Polynomial, steps_are_counted) {
    const auto f = with_roots<double>(1.0L, {-0.7L, -0.1L, 0.4L, 0.9L});
    const int sturm = find_solver("sturm")->id;
    EXPECT_EQ(test::first_root(f, -1.0, 1.0, 1e-6, sturm).steps, Solver<double>().sturm_halvings);
    const int split = find_solver("convexity_split")->id;
    const int steps = test::first_root(f, -1.0, 1.0, 1e-6, split).steps;
    EXPECT_GT(steps, 1);
    EXPECT_LE(steps, Solver<double>().newton_steps_max);
}

}  // namespace
}  // namespace quartic
