// Triangles of implicit surfaces against the surfaces.
#include "primitives/tessellate_implicit.h"

#include "tests/primitives/samples.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace quartic {
namespace {

template <class Shape>
class ImplicitTessellation : public ::testing::Test {};
TYPED_TEST_SUITE(ImplicitTessellation, test::ImplicitShapes);

double radius_xy(const glm::dvec3& p) {
    return std::sqrt(p.x * p.x + p.y * p.y);
}

// A torus around z with the value of a distance.
ImplicitSurface torus(double bend_radius, double radius) {
    ImplicitSurface surface;
    const auto from_spine = [=](const glm::dvec3& p) {
        const double rho = radius_xy(p);
        const double away = rho - bend_radius;
        return glm::dvec3(away * p.x / rho, away * p.y / rho, p.z);
    };
    surface.value = [=](const glm::dvec3& p) {
        return std::hypot(radius_xy(p) - bend_radius, p.z) - radius;
    };
    surface.gradient = [=](const glm::dvec3& p) { return glm::normalize(from_spine(p)); };
    return surface;
}

// How often each edge is used, and how many lie on the cube's faces.
struct Edges {
    int boundary = 0;
    int boundary_within = 0;
    int branching = 0;
};

Edges edges_of(const Triangles& triangles, double half_size) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;
    for (std::size_t i = 0; i < triangles.indices.size(); i += 3) {
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = triangles.indices[i + k];
            const std::uint32_t b = triangles.indices[i + (k + 1) % 3];
            ++uses[std::minmax(a, b)];
        }
    }
    const auto at_face = [&](std::uint32_t index) {
        const glm::dvec3 p = glm::abs(triangles.positions[index]);
        return std::max({p.x, p.y, p.z}) > (1.0 - 1e-9) * half_size;
    };
    Edges edges;
    for (const auto& [edge, count] : uses) {
        edges.boundary += count == 1;
        edges.boundary_within += count == 1 && !(at_face(edge.first) && at_face(edge.second));
        edges.branching += count > 2;
    }
    return edges;
}

TYPED_TEST(ImplicitTessellation, vertices_lie_on_the_surface_and_in_the_cube) {
    f64 kernel;
    for (const TypeParam& shape : test::samples<TypeParam>()) {
        const Triangles triangles = tessellate(shape, 1e-3 * shape.half_size);
        ASSERT_GT(triangles.indices.size(), 300u);
        ASSERT_EQ(triangles.positions.size(), triangles.normals.size());
        for (std::size_t i = 0; i < triangles.positions.size(); ++i) {
            const glm::dvec3& p = triangles.positions[i];
            EXPECT_LT(std::abs(kernel.value(shape, p)), 1e-10);
            EXPECT_LE(std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}),
                      shape.half_size * (1.0 + 1e-12));
            EXPECT_NEAR(glm::length(triangles.normals[i]), 1.0, 1e-9);
            const glm::dvec3 gradient = kernel.gradient(shape, p);
            if (glm::length(gradient) > 1e-9) {
                EXPECT_GT(glm::dot(gradient, triangles.normals[i]),
                          (1.0 - 1e-9) * glm::length(gradient));
            }
        }
    }
}

TYPED_TEST(ImplicitTessellation, the_mesh_is_open_at_the_faces_of_the_cube_alone) {
    for (const TypeParam& shape : test::samples<TypeParam>()) {
        const Triangles triangles = tessellate(shape, 2e-3 * shape.half_size);
        EXPECT_EQ(edges_of(triangles, shape.half_size).boundary_within, 0);
    }
}

TYPED_TEST(ImplicitTessellation, every_index_is_in_range) {
    for (const TypeParam& shape : test::samples<TypeParam>()) {
        const Triangles triangles = tessellate(shape, 1e-2 * shape.half_size);
        for (const std::uint32_t index : triangles.indices) {
            ASSERT_LT(index, triangles.positions.size());
        }
    }
}

TEST(TessellateImplicit, a_torus_is_closed_and_has_the_characteristic_of_one) {
    const Triangles triangles = tessellate_implicit(torus(0.6, 0.25), 1e-3);
    const Edges edges = edges_of(triangles, 1.0);
    EXPECT_EQ(edges.boundary, 0);
    EXPECT_EQ(edges.branching, 0);
    const auto faces = static_cast<long>(triangles.indices.size() / 3);
    const auto vertices = static_cast<long>(triangles.positions.size());
    EXPECT_EQ(vertices - 3 * faces / 2 + faces, 0);
}

TEST(TessellateImplicit, triangles_depart_by_the_sagitta_at_most_and_face_outwards) {
    const ImplicitSurface surface = torus(0.6, 0.25);
    for (const double sagitta : {1e-2, 1e-3, 5e-4}) {
        const Triangles triangles = tessellate_implicit(surface, sagitta);
        EXPECT_LE(triangles.deviation, sagitta);
        for (std::size_t i = 0; i < triangles.indices.size(); i += 3) {
            const glm::dvec3& a = triangles.positions[triangles.indices[i]];
            const glm::dvec3& b = triangles.positions[triangles.indices[i + 1]];
            const glm::dvec3& c = triangles.positions[triangles.indices[i + 2]];
            const glm::dvec3 middle = (a + b + c) / 3.0;
            EXPECT_LE(std::abs(surface.value(middle)), 1.5 * sagitta);
            const glm::dvec3 area = glm::cross(b - a, c - a);
            EXPECT_GE(glm::dot(area, surface.gradient(middle)), -1e-3 * glm::length(area));
        }
    }
}

TEST(TessellateImplicit, volume_and_area_are_those_of_the_torus) {
    const Triangles triangles = tessellate_implicit(torus(0.6, 0.25), 2e-4);
    double volume = 0.0;
    for (std::size_t i = 0; i < triangles.indices.size(); i += 3) {
        const glm::dvec3& a = triangles.positions[triangles.indices[i]];
        const glm::dvec3& b = triangles.positions[triangles.indices[i + 1]];
        const glm::dvec3& c = triangles.positions[triangles.indices[i + 2]];
        volume += glm::dot(a, glm::cross(b, c)) / 6.0;
    }
    EXPECT_NEAR(volume, 2.0 * 3.14159265 * 3.14159265 * 0.6 * 0.25 * 0.25, 2e-3);
}

TEST(TessellateImplicit, steps_are_bounded_and_what_was_reached_is_said) {
    const Triangles triangles = tessellate_implicit(torus(0.6, 0.25), 1e-12);
    EXPECT_GT(triangles.deviation, 1e-12);
    EXPECT_LT(triangles.deviation, 1e-3);
    EXPECT_LT(triangles.positions.size(), 2'000'000u);
}

// Two planes that cross: the crossing is rounded off by about a cell, and that is said.
TEST(TessellateImplicit, a_crossing_is_reported_as_a_deviation) {
    ImplicitSurface surface;
    surface.value = [](const glm::dvec3& p) { return (p.x - 0.01) * (p.y + 0.02); };
    surface.gradient = [](const glm::dvec3& p) { return glm::dvec3(p.y + 0.02, p.x - 0.01, 0.0); };
    const Triangles triangles = tessellate_implicit(surface, 1e-4);
    EXPECT_GT(triangles.deviation, 1e-4);
    EXPECT_LT(triangles.deviation, 2.0 * std::sqrt(3.0) / implicit_steps_max);
    EXPECT_EQ(edges_of(triangles, 1.0).boundary_within, 0);
}

TEST(TessellateImplicit, a_function_without_zeros_gives_nothing) {
    ImplicitSurface surface;
    surface.value = [](const glm::dvec3&) { return 1.0; };
    surface.gradient = [](const glm::dvec3&) { return glm::dvec3(0.0); };
    EXPECT_TRUE(tessellate_implicit(surface, 1e-3).indices.empty());
}

}  // namespace
}  // namespace quartic
