// The roots that count as true: chosen before their polynomials, and against quadruple precision.
#include "bench/truth.h"

#include "generators/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace quartic {
namespace {

using Coefficients = std::array<Long, 5>;

// Multiplies out (t - r) for every root, of rising powers.
Coefficients from_roots(const std::vector<Long>& roots) {
    Coefficients c{1.0L};
    for (const Long root : roots) {
        Coefficients next{};
        for (std::size_t i = 0; i < 4; ++i) {
            next[i + 1] += c[i];
            next[i] -= root * c[i];
        }
        c = next;
    }
    return c;
}

void expect_roots(const RealRoots& found, const std::vector<Long>& expected, Long error) {
    ASSERT_EQ(found.count, static_cast<int>(expected.size()));
    for (std::size_t i = 0; i < expected.size(); ++i) {
        EXPECT_NEAR(static_cast<double>(found.t[i] - expected[i]), 0.0, static_cast<double>(error));
    }
}

TEST(RealRoots, four_that_were_chosen) {
    expect_roots(real_roots(from_roots({-2.0L, -0.5L, 1.0L, 3.0L}), -10.0L, 10.0L),
                 {-2.0L, -0.5L, 1.0L, 3.0L}, 1e-18L);
}

TEST(RealRoots, of_lower_degrees) {
    expect_roots(real_roots({-6.0L, 11.0L, -6.0L, 1.0L, 0.0L}, -10.0L, 10.0L), {1.0L, 2.0L, 3.0L},
                 1e-18L);
    expect_roots(real_roots({-2.0L, 0.0L, 1.0L, 0.0L, 0.0L}, -10.0L, 10.0L),
                 {-std::sqrt(2.0L), std::sqrt(2.0L)}, 1e-18L);
    expect_roots(real_roots({1.0L, 4.0L, 0.0L, 0.0L, 0.0L}, -10.0L, 10.0L), {-0.25L}, 1e-18L);
}

TEST(RealRoots, none_where_there_are_none) {
    EXPECT_EQ(real_roots({1.0L, 0.0L, 1.0L, 0.0L, 1.0L}, -10.0L, 10.0L).count, 0);
    EXPECT_EQ(real_roots({3.0L, 0.0L, 0.0L, 0.0L, 0.0L}, -10.0L, 10.0L).count, 0);
    EXPECT_EQ(real_roots(from_roots({1.0L, 2.0L, 3.0L, 4.0L}), 5.0L, 4.0L).count, 0);
}

TEST(RealRoots, only_those_in_the_interval_with_its_ends) {
    const Coefficients c = from_roots({-2.0L, -1.0L, 1.0L, 2.0L});
    expect_roots(real_roots(c, -1.5L, 1.5L), {-1.0L, 1.0L}, 1e-18L);
    expect_roots(real_roots(c, -1.0L, 1.0L), {-1.0L, 1.0L}, 1e-18L);
    expect_roots(real_roots(c, 1.25L, 1.75L), {}, 0.0L);
}

// Powers of two: the products are exact, so the extreme touches zero exactly.
TEST(RealRoots, double_triple_and_quadruple_ones_stand_once) {
    expect_roots(real_roots(from_roots({-2.0L, 1.0L, 1.0L, 4.0L}), -10.0L, 10.0L),
                 {-2.0L, 1.0L, 4.0L}, 1e-15L);
    expect_roots(real_roots(from_roots({0.5L, 0.5L, 0.5L, 2.0L}), -10.0L, 10.0L), {0.5L, 2.0L},
                 1e-6L);
    expect_roots(real_roots(from_roots({0.5L, 0.5L, 0.5L, 0.5L}), -10.0L, 10.0L), {0.5L}, 1e-4L);
    expect_roots(real_roots(from_roots({-1.0L, -1.0L, 1.0L, 1.0L}), -10.0L, 10.0L), {-1.0L, 1.0L},
                 1e-15L);
}

TEST(RealRoots, two_that_nearly_touch_are_told_apart) {
    for (const Long gap : {1e-2L, 1e-4L, 1e-6L}) {
        const std::vector<Long> roots = {-1.0L, 0.5L, 0.5L + gap, 3.0L};
        // A change of 1e-19 in the polynomial moves roots by as much over the gap.
        expect_roots(real_roots(from_roots(roots), -10.0L, 10.0L), roots, 1e-17L / gap);
    }
}

TEST(RealRoots, two_that_just_fail_to_touch_are_none) {
    for (const Long gap : {1e-3L, 1e-6L, 1e-8L}) {
        // ((t - 0.5)^2 + gap^2) (t + 1) (t - 3).
        const Coefficients pair{0.25L + gap * gap, -1.0L, 1.0L};
        Coefficients c{};
        const Long other[] = {-3.0L, -2.0L, 1.0L};
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t j = 0; j < 3; ++j) {
                c[i + j] += pair[i] * other[j];
            }
        }
        expect_roots(real_roots(c, -10.0L, 10.0L), {-1.0L, 3.0L}, 1e-15L);
    }
}

TEST(RealRoots, of_any_scale) {
    for (const Long scale : {1e-6L, 1.0L, 1e6L}) {
        const std::vector<Long> roots = {-2.0L * scale, -0.5L * scale, scale, 3.0L * scale};
        expect_roots(real_roots(from_roots(roots), -10.0L * scale, 10.0L * scale), roots,
                     1e-17L * scale);
    }
}

// Quadruple precision: 113 bits.
__extension__ using Quad = __float128;

struct QuadPolynomial {
    std::array<Quad, 5> c{};  // of rising powers
    int degree = 0;
};

Quad value_at(const QuadPolynomial& f, Quad t) {
    Quad value = 0;
    for (int i = f.degree; i >= 0; --i) {
        value = value * t + f.c[static_cast<std::size_t>(i)];
    }
    return value;
}

QuadPolynomial derivative(const QuadPolynomial& f) {
    QuadPolynomial slope;
    slope.degree = f.degree - 1;
    for (int i = 1; i <= f.degree; ++i) {
        slope.c[static_cast<std::size_t>(i - 1)] = i * f.c[static_cast<std::size_t>(i)];
    }
    return slope;
}

// The remainder of f by g, its sign turned.
QuadPolynomial turned_remainder(QuadPolynomial f, const QuadPolynomial& g) {
    while (f.degree >= g.degree) {
        const Quad factor =
            f.c[static_cast<std::size_t>(f.degree)] / g.c[static_cast<std::size_t>(g.degree)];
        const int shift = f.degree - g.degree;
        for (int i = 0; i <= g.degree; ++i) {
            f.c[static_cast<std::size_t>(i + shift)] -= factor * g.c[static_cast<std::size_t>(i)];
        }
        --f.degree;
    }
    for (int i = 0; i <= f.degree; ++i) {
        f.c[static_cast<std::size_t>(i)] = -f.c[static_cast<std::size_t>(i)];
    }
    return f;
}

// Sturm's theorem: how many roots lie in an interval.
int count_roots(const QuadPolynomial& f, Long from, Long to) {
    const auto low = static_cast<Quad>(from);
    const auto high = static_cast<Quad>(to);
    std::vector<QuadPolynomial> chain{f, derivative(f)};
    while (chain.back().degree > 0) {
        chain.push_back(turned_remainder(chain[chain.size() - 2], chain.back()));
    }
    const auto changes = [&](Quad t) {
        int count = 0;
        Quad last = 0;
        for (const QuadPolynomial& one : chain) {
            const Quad value = value_at(one, t);
            count += (value < 0 && last > 0) || (value > 0 && last < 0);
            last = value != 0 ? value : last;
        }
        return count;
    };
    return changes(low) - changes(high);
}

// Coefficients of a quartic from its values at -2, -1, 0, 1 and 2.
QuadPolynomial through(const std::array<Quad, 5>& y) {
    const Quad odd1 = (y[3] - y[1]) / 2;
    const Quad odd2 = (y[4] - y[0]) / 4;
    const Quad even1 = (y[3] + y[1]) / 2 - y[2];
    const Quad even2 = ((y[4] + y[0]) / 2 - y[2]) / 4;
    QuadPolynomial f;
    f.degree = 4;
    f.c = {y[2], odd1 - (odd2 - odd1) / 3, even1 - (even2 - even1) / 3, (odd2 - odd1) / 3,
           (even2 - even1) / 3};
    return f;
}

Quad square(Quad x) {
    return x * x;
}

using QuadVector = std::array<Quad, 3>;

QuadVector point_on(const LongRay& ray, Quad t) {
    QuadVector p{};
    for (int axis = 0; axis < 3; ++axis) {
        p[static_cast<std::size_t>(axis)] =
            static_cast<Quad>(ray.origin[axis]) + t * static_cast<Quad>(ray.direction[axis]);
    }
    return p;
}

// The polynomial of f's values along a ray.
template <class Function>
QuadPolynomial along(const LongRay& ray, const Function& f) {
    std::array<Quad, 5> values{};
    for (int i = 0; i < 5; ++i) {
        values[static_cast<std::size_t>(i)] = f(point_on(ray, i - 2));
    }
    return through(values);
}

LongRay random_ray(Random& random, double reach) {
    const auto number = [&](double size) {
        return static_cast<Long>(static_cast<float>(random.between(-size, size)));
    };
    return {{number(reach), number(reach), number(reach)},
            {number(1.0), number(1.0), number(1.0)},
            static_cast<Long>(static_cast<float>(random.between(0.0, 0.5)))};
}

// Each root lies between two places, 1e-12 away, at which the quadruple polynomial changes its
// sign.
void expect_sign_changes(const QuadPolynomial& f, const RealRoots& roots) {
    for (int i = 0; i < roots.count; ++i) {
        const Quad t = static_cast<Quad>(roots.t[static_cast<std::size_t>(i)]);
        const Quad before = value_at(f, t - static_cast<Quad>(1e-12));
        const Quad after = value_at(f, t + static_cast<Quad>(1e-12));
        EXPECT_TRUE((before < 0) != (after < 0)) << static_cast<double>(t);
    }
}

TEST(Crossings, of_rings_are_those_of_quadruple_precision) {
    Random random(5);
    int roots = 0;
    for (int i = 0; i < 20000; ++i) {
        const f32::Torus ring{0.7f, static_cast<float>(random.between(0.01, 0.7)), 6.2831855f,
                              0.0f};
        const LongRay ray = random_ray(random, 1.0);
        const RealRoots found = crossings_of(ring)(ray);
        const Quad bend2 = square(static_cast<Quad>(ring.bend_radius));
        const Quad radius2 = square(static_cast<Quad>(ring.radius));
        const QuadPolynomial f = along(ray, [&](const QuadVector& p) {
            const Quad k = p[0] * p[0] + p[1] * p[1] + p[2] * p[2] - bend2 - radius2;
            return k * k + 4 * bend2 * (p[2] * p[2] - radius2);
        });
        ASSERT_EQ(found.count, count_roots(f, ray.first, 1e4L)) << "ray " << i;
        expect_sign_changes(f, found);
        roots += found.count;
    }
    EXPECT_GT(roots, 5000);
}

// Of a polynomial of this degree; a cubic's terms of degree 4 are zero.
std::array<float, 35> random_terms(Random& random, int degree) {
    std::array<float, 35> terms{};
    std::size_t term = 0;
    for (int a = 4; a >= 0; --a) {
        for (int b = 4 - a; b >= 0; --b) {
            for (int c = 4 - a - b; c >= 0; --c) {
                const double factor = random.between(-1.0, 1.0);
                terms[term++] = a + b + c <= degree ? static_cast<float>(factor) : 0.0f;
            }
        }
    }
    return terms;
}

// How many roots lie beyond the place where a ray that starts in the cube leaves it.
int outside(const QuadPolynomial& f, const LongRay& ray, float half_size) {
    Long exit = 1e6L;
    for (int axis = 0; axis < 3; ++axis) {
        const Long side = std::copysign(static_cast<Long>(half_size), ray.direction[axis]);
        exit = std::min(exit, (side - ray.origin[axis]) / ray.direction[axis]);
    }
    return exit > ray.first ? count_roots(f, exit, 1e6L) : count_roots(f, ray.first, 1e6L);
}

TEST(Crossings, of_algebraic_surfaces_are_those_of_quadruple_precision) {
    Random random(6);
    int roots = 0;
    for (int i = 0; i < 10000; ++i) {
        const int degree = i % 2 == 0 ? 4 : 3;
        const std::array<float, 35> terms = random_terms(random, degree);
        const float half_size = i % 3 == 0 ? 1.0f : 2.5f;
        const LongRay ray = random_ray(random, static_cast<double>(half_size));
        const RealRoots found = crossings_of(terms, half_size)(ray);
        QuadPolynomial f = along(ray, [&](const QuadVector& p) {
            Quad sum = 0;
            std::size_t term = 0;
            const auto power = [&](std::size_t axis, int exponent) {
                Quad value = 1;
                for (int n = 0; n < exponent; ++n) {
                    value *= p[axis] / static_cast<Quad>(half_size);
                }
                return value;
            };
            for (int a = 4; a >= 0; --a) {
                for (int b = 4 - a; b >= 0; --b) {
                    for (int c = 4 - a - b; c >= 0; --c) {
                        sum += static_cast<Quad>(terms[term++]) * power(0, a) * power(1, b) *
                               power(2, c);
                    }
                }
            }
            return sum;
        });
        f.degree = degree;  // a cubic's leading term is what rounding left
        ASSERT_EQ(found.count, count_roots(f, ray.first, 1e6L) - outside(f, ray, half_size))
            << "ray " << i;
        expect_sign_changes(f, found);
        for (int n = 0; n < found.count; ++n) {
            const Long t = found.t[static_cast<std::size_t>(n)];
            EXPECT_GE(t, ray.first);
            const LongVector place = glm::abs(ray.origin + t * ray.direction);
            EXPECT_LE(std::max({place.x, place.y, place.z}),
                      static_cast<Long>(half_size) * (1.0L + 1e-15L));
        }
        roots += found.count;
    }
    EXPECT_GT(roots, 2000);
}

}  // namespace
}  // namespace quartic
