// Polygons to triangles: area kept, holes left open, winding like the normals, and no work without
// bound.
#include "importers/facet_triangulation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace quartic {
namespace {

struct Outline {
    std::vector<glm::dvec3> positions;
    std::vector<glm::dvec3> normals;
    std::vector<std::uint32_t> sizes;

    // Points in a tilted plane far from the origin, as plants have them.
    void add(const std::vector<glm::dvec2>& points, bool against = false) {
        const glm::dvec3 u = glm::normalize(glm::dvec3(1, 2, -0.5));
        const glm::dvec3 n = glm::normalize(glm::cross(u, glm::dvec3(0.3, -0.2, 1)));
        const glm::dvec3 v = glm::cross(n, u);
        for (const glm::dvec2& p : points) {
            positions.push_back(glm::dvec3(310000, -120000, 42000) + p.x * u + p.y * v);
            normals.push_back(against ? -n : n);
        }
        sizes.push_back(static_cast<std::uint32_t>(points.size()));
    }
    FacetPolygon polygon() const { return {positions, normals, sizes}; }
};

struct Filled {
    FacetFault fault = FacetFault::none;
    double area = 0.0;     // of all triangles, without sign
    double against = 0.0;  // of those that wind against the normals
    std::size_t triangles = 0;
};

Filled fill(const Outline& outline) {
    FacetTriangulation triangulation;
    std::vector<std::uint32_t> triangles;
    Filled filled;
    filled.fault = triangulation.cut(outline.polygon(), triangles).fault;
    for (std::size_t i = 0; i + 2 < triangles.size(); i += 3) {
        const glm::dvec3 a = outline.positions[triangles[i]];
        const glm::dvec3 cross = glm::cross(outline.positions[triangles[i + 1]] - a,
                                            outline.positions[triangles[i + 2]] - a);
        filled.area += 0.5 * glm::length(cross);
        filled.against +=
            glm::dot(cross, outline.normals[triangles[i]]) < 0.0 ? 0.5 * glm::length(cross) : 0.0;
    }
    filled.triangles = triangles.size() / 3;
    return filled;
}

std::vector<glm::dvec2> regular(std::size_t corners, double radius, glm::dvec2 centre,
                                bool clockwise = false) {
    std::vector<glm::dvec2> points;
    for (std::size_t i = 0; i < corners; ++i) {
        const double turn =
            2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(corners);
        points.push_back(centre + radius * glm::dvec2(std::cos(turn), clockwise ? -std::sin(turn)
                                                                                : std::sin(turn)));
    }
    return points;
}

double regular_area(std::size_t corners, double radius) {
    const auto n = static_cast<double>(corners);
    return 0.5 * n * radius * radius * std::sin(2.0 * std::numbers::pi / n);
}

TEST(facets, convex_polygon_is_filled_by_n_minus_2_triangles) {
    for (const std::size_t corners :
         {std::size_t{3}, std::size_t{4}, std::size_t{5}, std::size_t{12}, std::size_t{100}}) {
        Outline outline;
        outline.add(regular(corners, 500, {0, 0}));
        const Filled filled = fill(outline);
        EXPECT_EQ(filled.fault, FacetFault::none);
        EXPECT_EQ(filled.triangles, corners - 2);
        EXPECT_NEAR(filled.area, regular_area(corners, 500), 1e-6 * 500 * 500);
        EXPECT_LT(filled.against, 1e-6 * filled.area);
    }
}

TEST(facets, winding_follows_the_normals_and_not_the_outline) {
    for (const bool clockwise : {false, true}) {
        for (const bool against : {false, true}) {
            Outline outline;
            outline.add(regular(7, 500, {0, 0}, clockwise), against);
            outline.add(regular(5, 100, {50, 20}, clockwise), against);
            const Filled filled = fill(outline);
            EXPECT_EQ(filled.fault, FacetFault::none);
            EXPECT_NEAR(filled.area, regular_area(7, 500) - regular_area(5, 100), 1e-6 * 500 * 500);
            EXPECT_LT(filled.against, 1e-6 * filled.area);
        }
    }
}

TEST(facets, l_shape_is_filled) {
    Outline outline;
    outline.add({{0, 0}, {10, 0}, {10, 2}, {2, 2}, {2, 8}, {0, 8}});
    const Filled filled = fill(outline);
    EXPECT_EQ(filled.fault, FacetFault::none);
    EXPECT_NEAR(filled.area, 32.0, 1e-6);
}

TEST(facets, many_holes_stay_open) {
    Outline outline;
    outline.add({{0, 0}, {4000, 0}, {4000, 4000}, {0, 4000}});
    double expected = 4000.0 * 4000.0;
    for (int x = 0; x < 20; ++x) {
        for (int y = 0; y < 20; ++y) {
            outline.add(regular(12, 60, {200.0 * x + 100, 200.0 * y + 100}, (x + y) % 2 == 0));
            expected -= regular_area(12, 60);
        }
    }
    const Filled filled = fill(outline);
    EXPECT_EQ(filled.fault, FacetFault::none);
    EXPECT_NEAR(filled.area, expected, 1e-6 * expected);
    EXPECT_LT(filled.against, 1e-6 * filled.area);
}

TEST(facets, hole_that_touches_the_outline_in_a_corner_is_filled) {
    Outline outline;
    outline.add({{0, 0}, {10, 0}, {10, 10}, {0, 10}});
    outline.add({{0, 0}, {4, 2}, {2, 4}});
    const Filled filled = fill(outline);
    EXPECT_NEAR(filled.area, 100.0 - 6.0, 1e-3);
}

TEST(facets, repeated_and_collinear_corners_do_no_harm) {
    Outline outline;
    outline.add(
        {{0, 0}, {5, 0}, {5, 0}, {10, 0}, {10, 5}, {10, 10}, {5, 10}, {0, 10}, {0, 5}, {0, 0}});
    const Filled filled = fill(outline);
    EXPECT_EQ(filled.fault, FacetFault::none);
    EXPECT_NEAR(filled.area, 100.0, 1e-6);
}

TEST(facets, star_shapes_with_noise_keep_their_area) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> radius(100, 1000);
    for (int round = 0; round < 200; ++round) {
        std::vector<glm::dvec2> points;
        const std::size_t corners = 5 + static_cast<std::size_t>(round) * 3;
        double area = 0.0;
        for (std::size_t i = 0; i < corners; ++i) {
            const double turn =
                2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(corners);
            points.push_back(radius(random) * glm::dvec2(std::cos(turn), std::sin(turn)));
        }
        for (std::size_t i = 0; i < corners; ++i) {
            const glm::dvec2 a = points[i];
            const glm::dvec2 b = points[(i + 1) % corners];
            area += 0.5 * (a.x * b.y - a.y * b.x);
        }
        Outline outline;
        outline.add(points);
        const Filled filled = fill(outline);
        ASSERT_EQ(filled.fault, FacetFault::none) << round;
        ASSERT_NEAR(filled.area, area, 1e-6 * area) << round;
        ASSERT_LT(filled.against, 1e-6 * filled.area);
    }
}

TEST(facets, degenerate_polygons_are_named) {
    Outline line;
    line.add({{0, 0}, {10, 0}, {20, 0}});
    EXPECT_EQ(fill(line).fault, FacetFault::no_area);
    Outline two;
    two.add({{0, 0}, {10, 0}});
    EXPECT_EQ(fill(two).fault, FacetFault::too_few_corners);
    EXPECT_EQ(fill(Outline()).fault, FacetFault::too_few_corners);
    Outline not_finite;
    not_finite.add({{0, 0}, {10, 0}, {10, 10}});
    not_finite.positions[1].y = std::nan("");
    EXPECT_EQ(fill(not_finite).fault, FacetFault::not_finite);
    EXPECT_EQ(severity_of(FacetFault::not_finite), Severity::loss);
}

TEST(facets, bow_tie_and_hole_outside_are_reported) {
    Outline bow_tie;
    bow_tie.add({{0, 0}, {10, 10}, {10, 0}, {0, 12}});
    EXPECT_EQ(fill(bow_tie).fault, FacetFault::not_filled);
    Outline outside;
    outside.add(regular(6, 10, {0, 0}));
    outside.add(regular(6, 2, {-50, 0}));
    EXPECT_EQ(fill(outside).fault, FacetFault::not_filled);
}

TEST(facets, contour_over_the_limit_is_refused) {
    Outline outline;
    outline.add(regular(facet_corners_max + 1, 1000, {0, 0}));
    const Filled filled = fill(outline);
    EXPECT_EQ(filled.fault, FacetFault::too_many_corners);
    EXPECT_EQ(filled.triangles, 0u);
}

TEST(facets, long_comb_is_filled_within_the_work_allowed) {
    // 100,000 thin teeth: plain ear clipping would look at every corner for every ear.
    std::vector<glm::dvec2> points{{0, -10}};
    constexpr int teeth = 50000;
    points.emplace_back(2.0 * teeth, -10);
    for (int i = teeth; i-- > 0;) {
        points.emplace_back(2.0 * i + 2.0, 0);
        points.emplace_back(2.0 * i + 1.0, 1000);
    }
    points.emplace_back(0, 0);
    Outline outline;
    outline.add(points);
    const Filled filled = fill(outline);
    const double expected = 2.0 * teeth * 10.0 + teeth * 1000.0;
    EXPECT_TRUE(filled.fault == FacetFault::none || filled.fault == FacetFault::out_of_work);
    EXPECT_LE(filled.area, expected * (1.0 + 1e-6));
}

TEST(facets, random_corners_end_within_the_work_allowed) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> coordinate(0, 1000);
    std::vector<glm::dvec2> points;
    for (int i = 0; i < 20000; ++i) {
        points.emplace_back(coordinate(random), coordinate(random));
    }
    Outline outline;
    outline.add(points);
    EXPECT_NE(fill(outline).fault, FacetFault::none);
}

}  // namespace
}  // namespace quartic
