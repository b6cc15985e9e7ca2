// The six views of de Toledo, Levy, Paul 2007, table 1: hits that a solver on floats loses.
#include "primitives/kernel.h"
#include "solvers/solver_table.h"
#include "tests/solvers/quartics.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>

namespace quartic {
namespace {

constexpr std::array<int, 6> angles_deg = {0, 18, 36, 54, 72, 90};

struct Count {
    int hits = 0;
    int lost = 0;      // the truth hits, also a little to every side
    int invented = 0;  // the truth misses, also a little to every side
    int far = 0;       // off by more than a tenth of the tube's radius
};

template <class Kernel>
typename Kernel::Torus torus() {
    typename Kernel::Torus shape{};
    shape.bend_radius = decltype(shape.bend_radius)(0.7);
    shape.radius = decltype(shape.radius)(0.3);
    shape.arc = decltype(shape.arc)(7.0);
    return shape;
}

// The ray through a place of the picture, in [-1, 1]; angle 0 looks along the axis.
f64::Ray ray_through(int angle_deg, double x, double y) {
    const double angle = angle_deg * std::numbers::pi / 180.0;
    const double half = std::tan(15.0 * std::numbers::pi / 180.0);
    const glm::dvec3 back(std::sin(angle), 0.0, std::cos(angle));
    const glm::dvec3 right(0.0, 1.0, 0.0);
    const glm::dvec3 up = glm::cross(back, right);
    const glm::dvec3 direction = glm::normalize(half * (x * right + y * up) - back);
    const glm::dvec3 eye = 5.579 * back;
    const double shift = glm::dot(eye, direction);
    return {eye - shift * direction, direction, shift, 0.0};
}

f32::Ray narrow(const f64::Ray& ray) {
    return {glm::vec3(ray.origin), glm::vec3(ray.direction), float(ray.first), 0.0f};
}

f64::Hit truth(const f64::Ray& ray) {
    return f64().hit(torus<f64>(), ray, 0, solver_default);
}

// Whether a ray a hundredth of a pixel aside differs in what it hits: no float can tell.
bool is_tie(int angle_deg, double x, double y, double pixel, bool found) {
    for (const double dx : {-0.01, 0.0, 0.01}) {
        for (const double dy : {-0.01, 0.0, 0.01}) {
            if (truth(ray_through(angle_deg, x + dx * pixel, y + dy * pixel)).found != found) {
                return true;
            }
        }
    }
    return false;
}

Count count(int angle_deg, int solver, int size) {
    Count count;
    const double pixel = 2.0 / size;
    for (int row = 0; row < size; ++row) {
        for (int column = 0; column < size; ++column) {
            const double x = (column + 0.5) * pixel - 1.0;
            const double y = (row + 0.5) * pixel - 1.0;
            const f64::Ray ray = ray_through(angle_deg, x, y);
            const f64::Hit expected = truth(ray);
            const f32::Hit found = f32().hit(torus<f32>(), narrow(ray), 0, solver);
            count.hits += expected.found;
            if (expected.found != found.found) {
                if (!is_tie(angle_deg, x, y, pixel, expected.found)) {
                    ++(expected.found ? count.lost : count.invented);
                }
            } else if (found.found && std::abs(double(found.t) - expected.t) > 0.03) {
                ++count.far;
            }
        }
    }
    return count;
}

std::array<Count, 6> six_angles(const char* name, int size = 256) {
    const SolverRow* row = find_solver(name);
    EXPECT_NE(row, nullptr) << name;
    std::array<Count, 6> counts{};
    for (std::size_t i = 0; i < counts.size() && row != nullptr; ++i) {
        counts[i] = count(angles_deg[i], row->id, size);
        std::printf("%-28s %2d deg: %6d hits, %5d lost, %3d false, %3d far\n", name, angles_deg[i],
                    counts[i].hits, counts[i].lost, counts[i].invented, counts[i].far);
    }
    return counts;
}

TEST(SixAngles, newton_as_printed_loses_about_one_hit_in_a_hundred) {
    for (const char* name : {"newton", "newton_fine"}) {
        const std::array<Count, 6> counts = six_angles(name);
        int hits = 0;
        int lost = 0;
        for (const Count& count : counts) {
            hits += count.hits;
            lost += count.lost;
            EXPECT_EQ(count.invented, 0);
            EXPECT_EQ(count.far, 0);
        }
        EXPECT_GT(lost, 0.003 * hits);
        EXPECT_LT(lost, 0.02 * hits);
        for (const std::size_t safe : {0u, 1u, 2u, 5u}) {
            EXPECT_EQ(counts[safe].lost, 0) << angles_deg[safe];
        }
        EXPECT_GT(counts[4].lost, counts[3].lost);
    }
}

TEST(SixAngles, solvers_without_a_flaw_lose_nothing) {
    for (const char* name : {"convexity_split", "newton_forward", "bracketed"}) {
        for (const Count& count : six_angles(name)) {
            EXPECT_GT(count.hits, 8000);
            EXPECT_EQ(count.lost, 0);
            EXPECT_EQ(count.invented, 0);
            EXPECT_EQ(count.far, 0);
        }
    }
}

TEST(SixAngles, halvings_and_closed_forms_err_on_few_rays) {
    for (const char* name : {"sturm", "double_derivative_bisection", "analytic"}) {
        int hits = 0;
        int wrong = 0;
        for (const Count& count : six_angles(name)) {
            hits += count.hits;
            wrong += count.lost + count.invented + count.far;
        }
        EXPECT_LT(wrong, 0.0005 * hits) << name;
    }
}

TEST(SixAngles, sphere_tracing_fattens_silhouettes_and_loses_next_to_nothing) {
    for (const char* name : {"sphere_tracing", "sphere_tracing_two_ray"}) {
        int hits = 0;
        int lost = 0;
        int invented = 0;
        int far = 0;
        for (const Count& count : six_angles(name)) {
            hits += count.hits;
            lost += count.lost;
            invented += count.invented;
            far += count.far;
        }
        EXPECT_LT(lost, 0.0005 * hits) << name;
        EXPECT_LT(far, 0.0005 * hits) << name;
        EXPECT_GT(invented, 0) << name;
        EXPECT_LT(invented, 0.003 * hits) << name;
    }
}

// Two methods that have nothing in common but their interval, on sectors, caps and thin tubes.
TEST(Elbows, bracketed_hits_what_convexity_split_hits) {
    test::Sequence<double> next(7);
    const int bracketed = find_solver("bracketed")->id;
    int hits = 0;
    int differ = 0;
    for (int i = 0; i < 40000; ++i) {
        const f64::Torus elbow{1.0, i % 4 == 0 ? 0.02 : 0.51 + 0.49 * next(), 3.2 + 3.0 * next(),
                               0.0};
        const glm::dvec3 direction(next(), next(), next());
        const f64::Ray ray{1.2 * glm::dvec3(next(), next(), next()), direction,
                           i % 2 == 0 ? 0.0 : -1e3, 0.0};
        const f64::Hit expected = f64().hit(elbow, ray, i % 4, solver_default);
        const f64::Hit found = f64().hit(elbow, ray, i % 4, bracketed);
        hits += expected.found;
        differ += found.found != expected.found ||
                  (found.found && glm::distance(found.point, expected.point) > 1e-6);
    }
    EXPECT_GT(hits, 8000);
    EXPECT_EQ(differ, 0);
}

}  // namespace
}  // namespace quartic
