// Rays and triangles of shapes that are given by where value() vanishes.
#include "primitives/tessellate.h"
#include "solvers/solver_table.h"
#include "tests/primitives/samples.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

namespace quartic {
namespace {

using test::Numbers;

template <class Shape>
class ImplicitSurfaces : public ::testing::Test {};
TYPED_TEST_SUITE(ImplicitSurfaces, test::ImplicitShapes);

// The first sign change of a function on [low, high], by small steps and halving; above high: none.
double first_change(const std::function<double(double)>& f, double low, double high) {
    constexpr int steps = 1500;
    double before = f(low);
    for (int i = 1; i <= steps; ++i) {
        const double t = low + (high - low) * i / steps;
        const double value = f(t);
        if ((before < 0.0) != (value < 0.0)) {
            double a = low + (high - low) * (i - 1) / steps;
            double b = t;
            for (int k = 0; k < 60; ++k) {
                const double middle = 0.5 * (a + b);
                ((f(middle) < 0.0) == (before < 0.0) ? a : b) = middle;
            }
            return 0.5 * (a + b);
        }
        before = value;
    }
    return 2.0 * high + 1.0;
}

// The part of a line in the cube.
struct Interval {
    double low = -1e300;
    double high = 1e300;
};

Interval in_cube(const f64::Ray& ray, double half_size) {
    Interval interval;
    for (int axis = 0; axis < 3; ++axis) {
        const double d = ray.direction[axis];
        if (d == 0.0) {
            if (std::abs(ray.origin[axis]) > half_size) {
                return {1.0, -1.0};
            }
            continue;
        }
        const double a = (-half_size - ray.origin[axis]) / d;
        const double b = (half_size - ray.origin[axis]) / d;
        interval.low = std::max(interval.low, std::min(a, b));
        interval.high = std::min(interval.high, std::max(a, b));
    }
    return interval;
}

struct Truth {
    bool found = false;
    double t = 0.0;
    double slant = 0.0;  // cosine between ray and normal
};

template <class Shape>
Truth truth_of(const Shape& shape, const f64::Ray& ray) {
    f64 kernel;
    Interval interval = in_cube(ray, shape.half_size);
    interval.low = std::max(interval.low, ray.first);
    Truth truth;
    if (!(interval.low < interval.high)) {
        return truth;
    }
    const auto along = [&](double t) {
        return kernel.value(shape, ray.origin + t * ray.direction);
    };
    truth.t = first_change(along, interval.low, interval.high);
    truth.found = truth.t <= interval.high;
    if (truth.found) {
        const glm::dvec3 gradient = kernel.gradient(shape, ray.origin + truth.t * ray.direction);
        truth.slant = std::abs(glm::dot(gradient, ray.direction)) /
                      (glm::length(gradient) * glm::length(ray.direction));
    }
    return truth;
}

template <class Shape>
f64::Ray random_ray(const Shape& shape, Numbers& numbers, bool from_within) {
    const double h = shape.half_size;
    const glm::dvec3 place(numbers.between(-h, h), numbers.between(-h, h), numbers.between(-h, h));
    const glm::dvec3 aim = numbers.direction();
    return test::ray_from(from_within ? place : place - 4.0 * h * aim, aim);
}

// Sign changes on small steps miss pairs of roots that lie close: only those differences count
// where the ray's hit is not the truth's or later.
template <class Shape>
void expect_hits_of_truth(const Shape& shape, bool from_within, int solver, int allowed) {
    f64 kernel;
    Numbers numbers(from_within ? 31 : 32);
    int hits = 0;
    int wrong = 0;
    for (int i = 0; i < 1500; ++i) {
        const f64::Ray ray = random_ray(shape, numbers, from_within);
        const Truth truth = truth_of(shape, ray);
        if (truth.found && truth.slant < 1e-3) {
            continue;
        }
        const f64::Hit hit = kernel.hit(shape, ray, 0, solver);
        hits += truth.found;
        const double size = 1e-5 * shape.half_size;  // Sturm halves to a millionth
        if (truth.found && (!hit.found || hit.t > truth.t + size)) {
            ++wrong;
        } else if (hit.found) {
            const double value = std::abs(kernel.value(shape, hit.point));
            const double slope = glm::length(kernel.gradient(shape, hit.point));
            wrong += value > 1e-5 * slope + 1e-12;
        }
    }
    EXPECT_GT(hits, 200);
    EXPECT_LE(wrong, allowed);
}

TYPED_TEST(ImplicitSurfaces, samples_have_no_fault) {
    for (const TypeParam& shape : test::samples<TypeParam>()) {
        EXPECT_EQ(find_fault(shape), "");
    }
}

TYPED_TEST(ImplicitSurfaces, the_gradient_is_the_slope_of_the_value) {
    f64 kernel;
    Numbers numbers(5);
    for (const TypeParam& shape : test::samples<TypeParam>()) {
        for (int i = 0; i < 100; ++i) {
            const glm::dvec3 p = shape.half_size * numbers.direction();
            const glm::dvec3 gradient = kernel.gradient(shape, p);
            for (int axis = 0; axis < 3; ++axis) {
                glm::dvec3 step(0.0);
                step[axis] = 1e-5 * shape.half_size;
                const double slope =
                    (kernel.value(shape, p + step) - kernel.value(shape, p - step)) / 2e-5;
                EXPECT_NEAR(gradient[axis], slope, 1e-8 * (1.0 + std::abs(slope)));
            }
        }
    }
}

TYPED_TEST(ImplicitSurfaces, rays_from_outside_hit_where_halving_finds_the_surface) {
    int index = 0;
    for (const TypeParam& shape : test::samples<TypeParam>()) {
        SCOPED_TRACE(index++);
        expect_hits_of_truth(shape, false, 1, 0);
    }
}

TYPED_TEST(ImplicitSurfaces, rays_from_within_the_cube_hit_where_halving_finds_the_surface) {
    int index = 0;
    for (const TypeParam& shape : test::samples<TypeParam>()) {
        SCOPED_TRACE(index++);
        expect_hits_of_truth(shape, true, 1, 0);
    }
}

TYPED_TEST(ImplicitSurfaces, every_solver_for_such_surfaces_finds_them) {
    int tried = 0;
    for (const SolverRow& row : solver_table()) {
        const std::string_view needed =
            type_of<TypeParam> == ShapeType::cubic ? "cubic" : "quartic";
        if (row.solves.find(needed) == std::string_view::npos) {
            continue;
        }
        SCOPED_TRACE(row.name);
        for (const TypeParam& shape : test::samples<TypeParam>()) {
            // The closed form loses digits where the leading coefficient almost vanishes.
            expect_hits_of_truth(shape, false, row.id, row.name == "analytic" ? 12 : 3);
        }
        ++tried;
    }
    EXPECT_GE(tried, 3);
}

TYPED_TEST(ImplicitSurfaces, axis_parallel_rays_hit_where_halving_finds_the_surface) {
    f64 kernel;
    int hits = 0;
    for (const TypeParam& shape : test::samples<TypeParam>()) {
        const double h = shape.half_size;
        for (int i = 0; i < 17 * 17; ++i) {
            for (int axis = 0; axis < 3; ++axis) {
                glm::dvec3 origin((i % 17 - 8) * h / 9.1, (i / 17 - 8) * h / 9.1, 0.0);
                std::swap(origin[axis], origin.z);
                glm::dvec3 direction(0.0);
                direction[axis] = i % 2 == 0 ? 1.0 : -1.0;
                const f64::Ray ray = test::ray_from(origin - 3.0 * h * direction, direction);
                const Truth truth = truth_of(shape, ray);
                const f64::Hit hit = kernel.hit(shape, ray, 0, 1);
                if (!truth.found || truth.slant < 1e-3) {
                    continue;
                }
                ASSERT_TRUE(hit.found) << i << ", axis " << axis;
                EXPECT_LT(hit.t, truth.t + 1e-6 * h);
                ++hits;
            }
        }
    }
    EXPECT_GT(hits, 300);
}

TYPED_TEST(ImplicitSurfaces, normals_are_parallel_to_the_gradient) {
    f64 kernel;
    Numbers numbers(8);
    int hits = 0;
    for (const TypeParam& shape : test::samples<TypeParam>()) {
        for (int i = 0; i < 500; ++i) {
            const f64::Hit hit = kernel.hit(shape, random_ray(shape, numbers, false), 0, 1);
            if (hit.found) {
                const glm::dvec3 gradient = kernel.gradient(shape, hit.point);
                EXPECT_NEAR(glm::length(hit.normal), 1.0, 1e-12);
                EXPECT_GT(glm::dot(hit.normal, gradient), (1.0 - 1e-9) * glm::length(gradient));
                ++hits;
            }
        }
    }
    EXPECT_GT(hits, 200);
}

TYPED_TEST(ImplicitSurfaces, hits_do_not_leave_the_cube) {
    f64 kernel;
    Numbers numbers(9);
    for (const TypeParam& shape : test::samples<TypeParam>()) {
        for (int i = 0; i < 2000; ++i) {
            const f64::Hit hit = kernel.hit(shape, random_ray(shape, numbers, i % 2 == 0), 0, 1);
            if (hit.found) {
                const glm::dvec3 p = glm::abs(hit.point);
                EXPECT_LE(std::max({p.x, p.y, p.z}), shape.half_size * (1.0 + 1e-9));
            }
        }
    }
}

TYPED_TEST(ImplicitSurfaces, what_lies_before_first_is_not_seen) {
    f64 kernel;
    Numbers numbers(10);
    for (const TypeParam& shape : test::samples<TypeParam>()) {
        for (int i = 0; i < 500; ++i) {
            f64::Ray ray = random_ray(shape, numbers, false);
            ray.first = numbers.between(3.0, 5.0) * shape.half_size;
            const f64::Hit hit = kernel.hit(shape, ray, 0, 1);
            EXPECT_TRUE(!hit.found || hit.t >= ray.first - 1e-9 * shape.half_size);
            ray.first = 10.0 * shape.half_size;
            EXPECT_FALSE(kernel.hit(shape, ray, 0, 1).found);
        }
    }
}

// The same lines in float and in long double, whose origins lie where the renderer starts them.
TYPED_TEST(ImplicitSurfaces, float_agrees_with_long_double) {
    using Exact = Kernel<long double>;
    for (const TypeParam& sample : test::samples<TypeParam>()) {
        const auto shape = test::to_float(sample);
        const auto exact = test::to_long_double(shape);
        Numbers numbers(12);
        int hits = 0;
        int different = 0;
        for (int i = 0; i < 3000; ++i) {
            const f64::Ray ray = random_ray(sample, numbers, true);
            f32::Ray thin{};
            thin.direction = glm::vec3(ray.direction);
            thin.origin = glm::vec3(ray.origin) - 1.5f * shape.half_size * thin.direction;
            Exact::Ray same{};
            same.direction = Exact::vec3(thin.direction);
            same.origin = Exact::vec3(thin.origin);
            const f32::Hit hit = f32().hit(shape, thin, 0, 1);
            const Exact::Hit truth = Exact().hit(exact, same, 0, 1);
            hits += truth.found;
            different += hit.found != truth.found ||
                         (hit.found && std::abs(static_cast<long double>(hit.t) - truth.t) >
                                           1e-4L * static_cast<long double>(shape.half_size));
        }
        EXPECT_GT(hits, 500);
        EXPECT_LE(different, 15) << "of " << hits;
    }
}

}  // namespace
}  // namespace quartic
