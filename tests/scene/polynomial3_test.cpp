// Polynomials in three variables against sums that are written out.
#include "scene/polynomial3.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace quartic {
namespace {

const Polynomial3 x = Polynomial3::x();
const Polynomial3 y = Polynomial3::y();
const Polynomial3 z = Polynomial3::z();

TEST(Polynomial3, terms_stand_in_the_order_of_the_manual_of_pov_ray) {
    const Polynomial3 terms[] = {power(x, 4),     power(x, 3) * y,
                                 power(x, 3) * z, power(x, 3),
                                 x * x * y * y,   x * x * y * z,
                                 x * x * y,       x * x * z * z,
                                 x * x * z,       x * x,
                                 x * power(y, 3), x * y * y * z,
                                 x * y * y,       x * y * z * z,
                                 x * y * z,       x * y,
                                 x * power(z, 3), x * z * z,
                                 x * z,           x,
                                 power(y, 4),     power(y, 3) * z,
                                 power(y, 3),     y * y * z * z,
                                 y * y * z,       y * y,
                                 y * power(z, 3), y * z * z,
                                 y * z,           y,
                                 power(z, 4),     power(z, 3),
                                 z * z,           z,
                                 Polynomial3(1.0)};
    for (std::size_t i = 0; i < std::size(terms); ++i) {
        for (std::size_t k = 0; k < Polynomial3::term_count; ++k) {
            EXPECT_EQ(terms[i].terms()[k], i == k ? 1.0 : 0.0) << i << ", " << k;
        }
    }
}

TEST(Polynomial3, cubic_terms_stand_in_the_order_of_the_manual_of_pov_ray) {
    const Polynomial3 terms[] = {power(x, 3), x * x * y,   x * x * z, x * x,     x * y * y,
                                 x * y * z,   x * y,       x * z * z, x * z,     x,
                                 power(y, 3), y * y * z,   y * y,     y * z * z, y * z,
                                 y,           power(z, 3), z * z,     z,         Polynomial3(1.0)};
    for (std::size_t i = 0; i < std::size(terms); ++i) {
        for (std::size_t k = 0; k < 20; ++k) {
            EXPECT_EQ(terms[i].cubic_terms()[k], i == k ? 1.0 : 0.0) << i << ", " << k;
        }
    }
}

TEST(Polynomial3, a_cubic_survives_the_way_to_twenty_terms_and_back) {
    std::array<double, 20> terms;
    std::iota(terms.begin(), terms.end(), 1.0);
    EXPECT_EQ(Polynomial3::from_cubic(terms).cubic_terms(), terms);
    EXPECT_EQ(Polynomial3::from_cubic(terms).degree(), 3);
}

TEST(Polynomial3, value_and_gradient_are_those_of_the_formula) {
    const Polynomial3 p = 2 * power(x, 4) - 3 * x * y * z + y * y * z * z + 4 * z - 5;
    const glm::dvec3 at(0.5, -2.0, 3.0);
    EXPECT_DOUBLE_EQ(p.value(at), 2 * 0.0625 + 9.0 + 36.0 + 12.0 - 5.0);
    const glm::dvec3 gradient = p.gradient(at);
    EXPECT_DOUBLE_EQ(gradient.x, 8 * 0.125 + 18.0);
    EXPECT_DOUBLE_EQ(gradient.y, -4.5 - 36.0);
    EXPECT_DOUBLE_EQ(gradient.z, 3.0 + 24.0 + 4.0);
}

TEST(Polynomial3, degrees_are_those_of_the_highest_term) {
    EXPECT_EQ(Polynomial3().degree(), 0);
    EXPECT_EQ(Polynomial3(7.0).degree(), 0);
    EXPECT_EQ((x * y - z).degree(), 2);
    EXPECT_EQ((power(x, 4) + y - power(x, 4)).degree(), 1);
}

TEST(Polynomial3Death, a_product_beyond_degree_four_is_a_bug) {
    EXPECT_DEATH(power(x + y, 5), "degree_max");
    EXPECT_DEATH((power(x, 4) + y).cubic_terms(), "degree");
}

TEST(Polynomial3, substitution_is_the_polynomial_of_the_mapped_point) {
    const Polynomial3 p = power(x - 2 * y, 4) + 3 * x * y * z - z * z + 1;
    const glm::dmat4x3 map(1.5, 0.25, -1.0, 0.0, 2.0, 0.5, 1.0, -0.5, 0.75, 0.1, -0.2, 0.3);
    const Polynomial3 q = p.of(map);
    for (const glm::dvec3& v : {glm::dvec3(0.0), glm::dvec3(1.0, -2.0, 0.5), glm::dvec3(-0.3)}) {
        EXPECT_NEAR(q.value(v), p.value(map * glm::dvec4(v, 1.0)), 1e-9);
    }
}

TEST(Polynomial3, text_reads_as_one_would_write_it) {
    EXPECT_EQ((x * x + y * y - 0.25).text(), "x^2 + y^2 - 0.25");
    EXPECT_EQ((-x * y + 3 * z).text(), "-x y + 3 z");
    EXPECT_EQ(Polynomial3().text(), "0");
    EXPECT_EQ(Polynomial3(-1.0).text(), "-1");
}

}  // namespace
}  // namespace quartic
