// Tori against an independent truth in long double: dense sampling of the distance from the spine,
// then bisection.
#include "tests/primitives/samples.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

namespace quartic {
namespace {

using test::Numbers;
using Long = long double;
using Vector = glm::vec<3, Long>;

constexpr Long turn = 2.0L * std::numbers::pi_v<Long>;

struct Ring {
    Long bend_radius;
    Long radius;
    Long arc;
};

// The line at the first crossing; a tie where the float below the last digit decides: grazing, or
// at an end's edge.
struct Truth {
    bool found = false;
    bool tie = false;
    Long t = 0.0L;
};

Long distance_from_wall(const Ring& ring, const Vector& p) {
    return std::hypot(std::hypot(p.x, p.y) - ring.bend_radius, p.z) - ring.radius;
}

// How far an angle is inside the arc; negative outside.
Long depth_in_arc(const Ring& ring, const Vector& p) {
    Long angle = std::atan2(p.y, p.x);
    if (angle < 0.0L) {
        angle += turn;
    }
    if (ring.arc >= turn - 1e-6L) {
        return 1.0L;
    }
    return angle <= ring.arc ? std::min(angle, ring.arc - angle)
                             : -std::min(angle - ring.arc, turn - angle);
}

// > 0 inside the solid, as a length that is small near its boundary.
Long depth_in_solid(const Ring& ring, const Vector& p) {
    return std::min(-distance_from_wall(ring, p), depth_in_arc(ring, p) * std::hypot(p.x, p.y));
}

Long bisect(const Ring& ring, const Vector& o, const Vector& d, Long low, Long high) {
    const bool inside = depth_in_solid(ring, o + low * d) > 0.0L;
    for (int i = 0; i < 80; ++i) {
        const Long middle = 0.5L * (low + high);
        ((depth_in_solid(ring, o + middle * d) > 0.0L) == inside ? low : high) = middle;
    }
    return low;
}

// Where the depth is greatest between two places around a sampled maximum (golden section).
Long deepest(const Ring& ring, const Vector& o, const Vector& d, Long low, Long high, Long sign) {
    const Long golden = 0.5L * (std::sqrt(5.0L) - 1.0L);
    for (int i = 0; i < 60; ++i) {
        const Long a = high - golden * (high - low);
        const Long b = low + golden * (high - low);
        const bool left =
            sign * depth_in_solid(ring, o + a * d) > sign * depth_in_solid(ring, o + b * d);
        (left ? high : low) = left ? b : a;
    }
    return 0.5L * (low + high);
}

// The samples of one line; a place deeper than both neighbours may hide a short chord between them.
Truth find_truth(const Ring& ring, const Vector& o, const Vector& d, Long tie_depth) {
    const Long outer = ring.bend_radius + ring.radius;
    const Long middle = -glm::dot(o, d);
    const Long room = outer * outer - (glm::dot(o, o) - middle * middle);
    Truth truth;
    if (room <= 0.0L) {
        truth.tie = room > -tie_depth * outer;
        return truth;
    }
    const Long first = std::max(0.0L, middle - std::sqrt(room));
    const Long last = middle + std::sqrt(room);
    const int steps = std::clamp(int(20.0L * (last - first) / ring.radius), 400, 40000);
    const Long step = (last - first) / Long(steps);
    const Long sign = depth_in_solid(ring, o + first * d) > 0.0L ? -1.0L : 1.0L;
    const auto depth_at = [&](Long t) { return sign * depth_in_solid(ring, o + t * d); };
    Long before = -1e9L;
    Long here = depth_at(first);
    Long extreme = -1e9L;
    for (int i = 1; i <= steps && last > first; ++i) {
        const Long t = first + step * Long(i);
        const Long next = depth_at(t);
        const bool peak = here >= before && here >= next && here > -2.0L * step;
        const Long top = peak ? deepest(ring, o, d, std::max(first, t - 2.0L * step), t, sign) : t;
        extreme = std::max(extreme, depth_at(top));
        if (next > 0.0L || depth_at(top) > 0.0L) {
            truth.found = true;
            const Long reached = depth_at(top) > 0.0L ? top : t;
            truth.t = bisect(ring, o, d, std::max(first, reached - 2.0L * step), reached);
            return truth;
        }
        before = here;
        here = next;
    }
    truth.tie = extreme > -tie_depth;
    return truth;
}

// Whether moving the ray sideways by the tie depth changes what it meets.
bool is_tie(const Ring& ring, const Vector& o, const Vector& d, const Truth& truth,
            Long tie_depth) {
    if (truth.tie) {
        return true;
    }
    const Vector axis = std::abs(d.x) < 0.6L ? Vector(1, 0, 0) : Vector(0, 1, 0);
    const Vector u = glm::normalize(glm::cross(d, axis));
    const Vector v = glm::cross(d, u);
    for (const Vector& aside : {u, -u, v, -v}) {
        const Truth beside = find_truth(ring, o + tie_depth * aside, d, 0.0L);
        if (beside.found != truth.found ||
            (truth.found && std::abs(beside.t - truth.t) > 0.1L * ring.radius)) {
            return true;
        }
    }
    return false;
}

struct Score {
    long hits = 0;
    long missed = 0;
    long falsely = 0;
    long elsewhere = 0;
    long ties = 0;
    Long worst = 0.0L;

    void operator+=(const Score& other) {
        hits += other.hits;
        missed += other.missed;
        falsely += other.falsely;
        elsewhere += other.elsewhere;
        ties += other.ties;
        worst = std::max(worst, other.worst);
    }
};

template <class Real>
void judge(Score& score, const Ring& ring, const glm::dvec3& from, const glm::dvec3& to) {
    using K = Kernel<Real>;
    typename K::Ray ray{};
    ray.origin = typename K::vec3(from);
    ray.direction = typename K::vec3(glm::normalize(to - from));
    ray.first = Real(0);
    const Vector o(ray.origin);
    const Long length = glm::length(Vector(ray.direction));
    const Vector d = Vector(ray.direction) / length;
    const typename K::Torus torus{Real(ring.bend_radius), Real(ring.radius), Real(ring.arc),
                                  Real(0)};
    // A hundredth of a tube's thousandth, or what the rounding of coordinates moves.
    const Long rounding = sizeof(Real) == 4 ? 2e-7L : 1e-15L;
    const Long tie_depth = (sizeof(Real) == 4 ? 1e-3L : 1e-6L) * ring.radius +
                           8.0L * rounding * (glm::length(o) + ring.bend_radius);
    const Truth truth = find_truth(ring, o, d, tie_depth);
    const typename K::Hit hit = K().hit(torus, ray, 0, 1);
    score.hits += truth.found;
    const Long error = std::abs(Long(hit.t) * length - truth.t) / ring.radius;
    const bool right = truth.found == hit.found && (!truth.found || error < 0.1L);
    if (right) {
        score.worst = truth.found && error > score.worst ? error : score.worst;
        return;
    }
    if (is_tie(ring, o, d, truth, tie_depth)) {
        ++score.ties;
    } else if (truth.found != hit.found) {
        ++(truth.found ? score.missed : score.falsely);
    } else {
        ++score.elsewhere;
    }
}

// Eyes around the torus, inside the tube, and far away, looking at places in and near the tube.
template <class Real>
Score run(const Ring& ring, double distance, int rays) {
    Numbers numbers(42);
    Score score;
    const double size = double(ring.bend_radius + ring.radius);
    const auto place_near_tube = [&](double spread) {
        const double angle = numbers.between(-0.05, double(ring.arc) + 0.05);
        const glm::dvec3 spine(std::cos(angle), std::sin(angle), 0.0);
        return double(ring.bend_radius) * spine +
               spread * double(ring.radius) * numbers.next() * numbers.direction();
    };
    for (int i = 0; i < rays; ++i) {
        const glm::dvec3 eye =
            distance == 0.0 ? place_near_tube(0.9) : distance * size * numbers.direction();
        judge<Real>(score, ring, eye, place_near_tube(1.3));
    }
    return score;
}

constexpr double ratios[] = {1.0, 1.05, 1.5, 1.9, 2.1, 2.66, 5.0, 20.0, 62.0, 150.0, 400.0};
constexpr double arcs_deg[] = {1.0, 15.0, 45.0, 90.0, 179.0, 180.0, 181.0, 270.0, 345.0, 360.0};

template <class Real>
Score run_all(double distance) {
    Score all;
    for (const double ratio : ratios) {
        for (const double arc_deg : arcs_deg) {
            const Long arc = arc_deg == 360.0 ? turn : Long(arc_deg) * turn / 360.0L;
            const Ring ring{Long(Real(0.1 * ratio)), Long(Real(0.1)), Long(Real(arc))};
            const Score score = run<Real>(ring, distance, ratio > 50.0 ? 25 : 80);
            if (score.missed + score.falsely + score.elsewhere > 0) {
                std::printf("R/r %g arc %g: missed %ld false %ld elsewhere %ld\n", ratio, arc_deg,
                            score.missed, score.falsely, score.elsewhere);
            }
            all += score;
        }
    }
    std::printf(
        "%ld hits, missed %ld, false %ld, elsewhere %ld, ties %ld, worst %.1Le of the tube's "
        "radius\n",
        all.hits, all.missed, all.falsely, all.elsewhere, all.ties, all.worst);
    return all;
}

template <class Real>
class TorusTruth : public ::testing::Test {};
using Reals = ::testing::Types<float, double>;
TYPED_TEST_SUITE(TorusTruth, Reals);

// Of the tube's radius; a float's coordinates are R / r times coarser than the tube.
template <class Real>
constexpr Long error_max = sizeof(Real) == 4 ? 0.1L : 1e-5L;

template <class Real>
void expect_right(double distance) {
    const Score score = run_all<Real>(distance);
    EXPECT_GT(score.hits, 3000);
    EXPECT_EQ(score.missed, 0);
    EXPECT_EQ(score.falsely, 0);
    EXPECT_EQ(score.elsewhere, 0);
    EXPECT_LT(score.worst, error_max<Real>);
    EXPECT_LT(score.ties, score.hits / 50);
}

TYPED_TEST(TorusTruth, eyes_near_the_torus) {
    expect_right<TypeParam>(1.5);
}

TYPED_TEST(TorusTruth, eyes_inside_the_tube) {
    expect_right<TypeParam>(0.0);
}

TYPED_TEST(TorusTruth, eyes_far_away) {
    expect_right<TypeParam>(30.0);
}

}  // namespace
}  // namespace quartic
