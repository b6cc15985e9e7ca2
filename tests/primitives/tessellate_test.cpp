// Triangles against the surface that they stand for.
#include "primitives/tessellate.h"

#include "tests/primitives/samples.h"

#include <algorithm>
#include <cmath>

namespace quartic {
namespace {

template <class Shape>
class Tessellation : public ::testing::Test {};
TYPED_TEST_SUITE(Tessellation, test::AllShapes);

glm::dvec3 centre_of(const Triangles& triangles, std::size_t first) {
    return (triangles.positions[triangles.indices[first]] +
            triangles.positions[triangles.indices[first + 1]] +
            triangles.positions[triangles.indices[first + 2]]) /
           3.0;
}

glm::dvec3 area_vector(const Triangles& triangles, std::size_t first) {
    const glm::dvec3 a = triangles.positions[triangles.indices[first]];
    const glm::dvec3 b = triangles.positions[triangles.indices[first + 1]];
    const glm::dvec3 c = triangles.positions[triangles.indices[first + 2]];
    return 0.5 * glm::cross(b - a, c - a);
}

TYPED_TEST(Tessellation, indices_are_in_range_and_normals_are_unit) {
    for (const TypeParam& shape : test::samples<TypeParam>()) {
        const Triangles triangles = tessellate(shape, 1e-3 * test::size_of(shape));
        ASSERT_GT(triangles.indices.size(), 0u);
        ASSERT_EQ(triangles.positions.size(), triangles.normals.size());
        for (const std::uint32_t index : triangles.indices) {
            ASSERT_LT(index, triangles.positions.size());
        }
        for (const glm::dvec3& normal : triangles.normals) {
            EXPECT_NEAR(glm::length(normal), 1.0, 1e-9);
        }
    }
}

TYPED_TEST(Tessellation, triangles_face_as_their_normals_do) {
    int index = 0;
    for (const TypeParam& shape : test::samples<TypeParam>()) {
        SCOPED_TRACE(index++);
        const Triangles triangles = tessellate(shape, 1e-4 * test::size_of(shape));
        for (std::size_t i = 0; i < triangles.indices.size(); i += 3) {
            const glm::dvec3 area = area_vector(triangles, i);
            for (std::size_t k = 0; k < 3; ++k) {
                ASSERT_GT(glm::dot(area, triangles.normals[triangles.indices[i + k]]),
                          -1e-3 * glm::length(area));
            }
        }
    }
}

// A ray along the triangle's normal from just off its centre must meet the surface within the
// sagitta.
TYPED_TEST(Tessellation, triangles_depart_by_the_sagitta_at_most) {
    f64 kernel;
    int index = 0;
    for (const TypeParam& shape : test::samples<TypeParam>()) {
        SCOPED_TRACE(index++);
        const double size = test::size_of(shape);
        const double sagitta = 1e-4 * size;
        const Triangles triangles = tessellate(shape, sagitta);
        int missed = 0;
        for (std::size_t i = 0; i < triangles.indices.size(); i += 3) {
            const glm::dvec3 area = area_vector(triangles, i);
            const glm::dvec3 normal = area / glm::length(area);
            f64::Ray ray{};
            ray.direction = -normal;
            ray.origin = centre_of(triangles, i) + 1.02 * sagitta * normal;
            ray.first = 0.0;
            const f64::Hit hit = kernel.hit(shape, ray, 0, 1);
            missed += !hit.found || hit.t > 2.04 * sagitta;
        }
        EXPECT_EQ(missed, 0) << "of " << triangles.indices.size() / 3;
    }
}

TYPED_TEST(Tessellation, all_faces_together_are_closed) {
    int index = 0;
    for (const TypeParam& shape : test::samples<TypeParam>()) {
        SCOPED_TRACE(index++);
        if (type_of<TypeParam> == ShapeType::disk) {
            continue;
        }
        const double size = test::size_of(shape);
        const Triangles triangles = tessellate(shape, 1e-5 * size);
        glm::dvec3 sum(0.0);
        double area = 0.0;
        for (std::size_t i = 0; i < triangles.indices.size(); i += 3) {
            sum += area_vector(triangles, i);
            area += glm::length(area_vector(triangles, i));
        }
        EXPECT_LT(glm::length(sum), 1e-3 * area);  // the area vectors of a closed surface cancel
    }
}

TYPED_TEST(Tessellation, hidden_caps_are_left_out) {
    f64 kernel;
    for (const TypeParam& shape : test::samples<TypeParam>()) {
        const double sagitta = 1e-3 * test::size_of(shape);
        const std::size_t all = tessellate(shape, sagitta).indices.size();
        const std::size_t open = tessellate(shape, sagitta, 3).indices.size();
        bool caps = false;
        for (int i = 0; i < kernel.end_count(shape); ++i) {
            caps = caps || kernel.end(shape, i).radius > 0.0;
        }
        if (caps) {
            EXPECT_LT(open, all);
        } else if (kernel.end_count(shape) == 0) {
            EXPECT_EQ(open, all);
        }
    }
}

TEST(Tessellate, a_box_is_twelve_triangles) {
    EXPECT_EQ(tessellate(f64::Box{1.0, 2.0, 3.0, 0.0}, 1e-6).indices.size(), 36u);
}

TEST(Tessellate, a_coarse_cylinder_still_is_a_prism) {
    const Triangles triangles = tessellate(f64::Cylinder{1.0, 2.0, 0.0, 0.0}, 10.0);
    EXPECT_GE(triangles.indices.size(), 3u * (6u + 2u * 1u));
}

TEST(Tessellate, steps_are_bounded) {
    const Triangles triangles = tessellate(f64::Cylinder{1.0, 2.0, 0.0, 0.0}, 1e-15);
    EXPECT_LE(triangles.positions.size(), 3u * 2u * 4097u);
}

TEST(Tessellate, a_finer_sagitta_gives_about_as_many_more_steps_as_circles_need) {
    const double coarse =
        double(tessellate(f64::Cylinder{1.0, 2.0, 0.0, 0.0}, 1e-3).indices.size());
    const double fine = double(tessellate(f64::Cylinder{1.0, 2.0, 0.0, 0.0}, 1e-5).indices.size());
    EXPECT_NEAR(fine / coarse, 10.0, 1.0);
}

}  // namespace
}  // namespace quartic
