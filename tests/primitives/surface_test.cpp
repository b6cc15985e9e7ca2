// Bounds, point() and hit() of every shape prove each other.
#include "tests/primitives/samples.h"

#include <algorithm>
#include <cmath>

namespace quartic {
namespace {

using test::Numbers;

template <class Shape>
class Surface : public ::testing::Test {};
TYPED_TEST_SUITE(Surface, test::AllShapes);

TYPED_TEST(Surface, samples_have_no_fault) {
    for (const TypeParam& shape : test::samples<TypeParam>()) {
        EXPECT_EQ(find_fault(shape), "");
    }
}

TYPED_TEST(Surface, bounds_hold_all_points_and_are_tight) {
    f64 kernel;
    int index = 0;
    for (const TypeParam& shape : test::samples<TypeParam>()) {
        SCOPED_TRACE(index++);
        const f64::Bounds box = kernel.bounds(shape);
        glm::dvec3 low(1e300);
        glm::dvec3 high(-1e300);
        const int steps = 240;
        for (int face = 0; face < kernel.face_count(shape); ++face) {
            for (int i = 0; i <= steps; ++i) {
                for (int j = 0; j <= steps; ++j) {
                    const glm::dvec3 p =
                        kernel.point(shape, face, {double(i) / steps, double(j) / steps});
                    low = glm::min(low, p);
                    high = glm::max(high, p);
                }
            }
        }
        const double size = test::size_of(shape);
        for (int axis = 0; axis < 3; ++axis) {
            EXPECT_GE(low[axis], box.low[axis] - 1e-9 * size) << "axis " << axis;
            EXPECT_LE(high[axis], box.high[axis] + 1e-9 * size) << "axis " << axis;
            EXPECT_LE(low[axis], box.low[axis] + 5e-4 * size) << "axis " << axis;
            EXPECT_GE(high[axis], box.high[axis] - 5e-4 * size) << "axis " << axis;
        }
    }
}

// Visits points well inside every face that has an area there, with their normals.
template <class Shape, class Visitor>
void visit_points(const Shape& shape, Visitor visitor) {
    f64 kernel;
    Numbers numbers(7);
    for (int face = 0; face < kernel.face_count(shape); ++face) {
        for (int i = 0; i < 60; ++i) {
            const double u = numbers.between(0.02, 0.98);
            const double v = numbers.between(0.02, 0.98);
            const glm::dvec3 normal = test::patch_normal(shape, face, u, v);
            if (normal != glm::dvec3(0.0)) {
                visitor(kernel.point(shape, face, {u, v}), normal);
            }
        }
    }
}

TYPED_TEST(Surface, a_ray_from_outside_hits_the_point_that_it_is_aimed_at) {
    f64 kernel;
    int index = 0;
    int visited = 0;
    for (const TypeParam& shape : test::samples<TypeParam>()) {
        SCOPED_TRACE(index++);
        const double size = test::size_of(shape);
        visit_points(shape, [&](const glm::dvec3& p, const glm::dvec3& normal) {
            const double away = 1e-6 * size;
            const f64::Hit hit =
                kernel.hit(shape, test::ray_from(p + away * normal, -3.0 * normal), 0, 1);
            ASSERT_TRUE(hit.found);
            EXPECT_LT(glm::length(hit.point - p), 1e-9 * size);
            EXPECT_NEAR(hit.t, away / 3.0, 1e-9 * size);
            EXPECT_GT(glm::dot(hit.normal, normal), 1.0 - 1e-7);
            ++visited;
        });
    }
    EXPECT_GT(visited, 100);
}

TYPED_TEST(Surface, a_ray_from_inside_hits_the_wall_with_its_outer_normal) {
    f64 kernel;
    int index = 0;
    for (const TypeParam& shape : test::samples<TypeParam>()) {
        SCOPED_TRACE(index++);
        if (test::is_flat(shape)) {
            continue;
        }
        const double size = test::size_of(shape);
        visit_points(shape, [&](const glm::dvec3& p, const glm::dvec3& normal) {
            const double away = 1e-6 * size;
            const f64::Hit hit =
                kernel.hit(shape, test::ray_from(p - away * normal, 0.01 * normal), 0, 1);
            ASSERT_TRUE(hit.found);
            EXPECT_LT(glm::length(hit.point - p), 1e-9 * size);
            EXPECT_GT(glm::dot(hit.normal, normal), 1.0 - 1e-7);
        });
    }
}

TYPED_TEST(Surface, no_point_is_hidden_from_a_ray_towards_it) {
    f64 kernel;
    Numbers numbers(11);
    int index = 0;
    for (const TypeParam& shape : test::samples<TypeParam>()) {
        SCOPED_TRACE(index++);
        const double size = test::size_of(shape);
        visit_points(shape, [&](const glm::dvec3& p, const glm::dvec3& normal) {
            const glm::dvec3 aim = numbers.direction();
            if (std::abs(glm::dot(aim, normal)) < 1e-3) {
                return;
            }
            const glm::dvec3 origin = p - 2.0 * size * aim;
            const f64::Hit hit = kernel.hit(shape, test::ray_from(origin, aim), 0, 1);
            ASSERT_TRUE(hit.found);
            EXPECT_LT(hit.t, 2.0 * size * (1.0 + 1e-9));
        });
    }
}

}  // namespace
}  // namespace quartic
