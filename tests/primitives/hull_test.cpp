// The proxies that start the rays: closed, wound outwards, around every point of the surface.
#include "tests/primitives/samples.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace quartic {
namespace {

using test::Numbers;
using Triangle = std::array<glm::dvec3, 3>;

template <class Shape>
class Hull : public ::testing::Test {};
TYPED_TEST_SUITE(Hull, test::AllShapes);

// Quads between neighbouring rings of eight corners, fans over the first and the last one.
template <class Shape>
std::vector<Triangle> hull_of(const Shape& shape, double margin) {
    f64 kernel;
    const int rings = kernel.hull_rings(shape);
    const auto corner = [&](int ring, int index) {
        return kernel.hull_point(shape, ring, index % 8, margin);
    };
    std::vector<Triangle> triangles;
    for (int ring = 0; ring + 1 < rings; ++ring) {
        for (int i = 0; i < 8; ++i) {
            triangles.push_back({corner(ring, i), corner(ring, i + 1), corner(ring + 1, i + 1)});
            triangles.push_back({corner(ring, i), corner(ring + 1, i + 1), corner(ring + 1, i)});
        }
    }
    for (int i = 1; i < 7; ++i) {
        triangles.push_back({corner(0, 0), corner(0, i + 1), corner(0, i)});
        triangles.push_back({corner(rings - 1, 0), corner(rings - 1, i), corner(rings - 1, i + 1)});
    }
    return triangles;
}

double volume_of(const std::vector<Triangle>& triangles) {
    double volume = 0.0;
    for (const Triangle& t : triangles) {
        volume += glm::dot(t[0], glm::cross(t[1], t[2])) / 6.0;
    }
    return volume;
}

// How often the hull winds around a point: +-1 and more inside, 0 outside (solid angles, van
// Oosterom and Strackee 1983).
double winding_of(const std::vector<Triangle>& triangles, const glm::dvec3& p) {
    double angle = 0.0;
    for (const Triangle& t : triangles) {
        const glm::dvec3 a = t[0] - p;
        const glm::dvec3 b = t[1] - p;
        const glm::dvec3 c = t[2] - p;
        const double la = glm::length(a);
        const double lb = glm::length(b);
        const double lc = glm::length(c);
        const double down =
            la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb;
        angle += 2.0 * std::atan2(glm::dot(a, glm::cross(b, c)), down);
    }
    return angle / (4.0 * 3.14159265358979323846);
}

TYPED_TEST(Hull, rings_are_few_enough_for_the_renderer) {
    for (const TypeParam& shape : test::samples<TypeParam>()) {
        EXPECT_GE(f64().hull_rings(shape), 2);
        EXPECT_LE(f64().hull_rings(shape), 17);
    }
}

TYPED_TEST(Hull, all_hulls_are_wound_the_same_way) {
    int index = 0;
    for (const TypeParam& shape : test::samples<TypeParam>()) {
        SCOPED_TRACE(index++);
        const double size = test::size_of(shape);
        EXPECT_GT(volume_of(hull_of(shape, 1e-4 * size)), 0.0);
    }
}

TYPED_TEST(Hull, the_hull_holds_every_point) {
    f64 kernel;
    Numbers numbers(13);
    int index = 0;
    for (const TypeParam& shape : test::samples<TypeParam>()) {
        SCOPED_TRACE(index++);
        for (const double margin : {1e-6, 1e-4, 1e-2}) {
            const std::vector<Triangle> hull = hull_of(shape, margin * test::size_of(shape));
            for (int face = 0; face < kernel.face_count(shape); ++face) {
                for (int i = 0; i < 60; ++i) {
                    const glm::dvec2 uv(i % 4 == 0 ? 0.01 + double(i % 3) * 0.49 : numbers.next(),
                                        i % 5 == 0 ? double(i % 2) : numbers.next());
                    if (test::patch_normal(shape, face, uv.x, uv.y) == glm::dvec3(0.0)) {
                        continue;
                    }
                    const double winding = winding_of(hull, kernel.point(shape, face, uv));
                    ASSERT_GT(std::abs(winding), 0.5)
                        << "face " << face << " at " << uv.x << ' ' << uv.y;
                }
            }
        }
    }
}

TYPED_TEST(Hull, no_point_lies_beyond_the_farthest_one) {
    f64 kernel;
    Numbers numbers(17);
    int index = 0;
    for (const TypeParam& shape : test::samples<TypeParam>()) {
        SCOPED_TRACE(index++);
        const double size = test::size_of(shape);
        const f64::Bounds box = kernel.bounds(shape);
        for (int i = 0; i < 40; ++i) {
            const glm::dvec3 direction = numbers.direction();
            const glm::dvec3 farthest = kernel.farthest(shape, direction);
            for (int face = 0; face < kernel.face_count(shape); ++face) {
                for (int k = 0; k < 40; ++k) {
                    const glm::dvec3 p =
                        kernel.point(shape, face, {numbers.next(), numbers.next()});
                    EXPECT_LE(glm::dot(p, direction), glm::dot(farthest, direction) + 1e-9 * size);
                }
            }
            // Nor is it far beyond them: an end's round cap may stand out of the box by its radius.
            for (int axis = 0; axis < 3; ++axis) {
                EXPECT_GE(farthest[axis], box.low[axis] - 0.5 * size);
                EXPECT_LE(farthest[axis], box.high[axis] + 0.5 * size);
            }
        }
    }
}

TYPED_TEST(Hull, the_hull_is_not_much_bigger_than_the_bounds) {
    f64 kernel;
    int index = 0;
    for (const TypeParam& shape : test::samples<TypeParam>()) {
        SCOPED_TRACE(index++);
        const f64::Bounds box = kernel.bounds(shape);
        const double size = test::size_of(shape);
        for (int ring = 0; ring < kernel.hull_rings(shape); ++ring) {
            for (int corner = 0; corner < 8; ++corner) {
                const glm::dvec3 p = kernel.hull_point(shape, ring, corner, 0.0);
                for (int axis = 0; axis < 3; ++axis) {
                    EXPECT_GT(p[axis], box.low[axis] - 0.3 * size);
                    EXPECT_LT(p[axis], box.high[axis] + 0.3 * size);
                }
            }
        }
    }
}

}  // namespace
}  // namespace quartic
