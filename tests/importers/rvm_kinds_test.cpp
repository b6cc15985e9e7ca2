// Every kind of primitive from hand-made bytes: what it becomes, where, and with which parameters.
#include "tests/importers/rvm_bytes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace quartic {
namespace {

constexpr float nan_value = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr double pi = std::numbers::pi;

Scene load_one(std::uint32_t kind, std::initializer_list<float> parameters,
               const std::array<float, 12>& matrix = plain_matrix,
               const std::array<float, 6>& box = wide_box) {
    Result<Scene> scene = load_bytes(
        RvmBytes().head().group("G").primitive(kind, parameters, matrix, box).end_group().end());
    EXPECT_TRUE(scene.ok());
    return std::move(scene).value();
}

TEST(rvm_kinds, cylinder_is_in_metres_where_the_matrix_says) {
    const Scene scene = load_one(8, {50, 200});
    ASSERT_EQ(scene.parts.size(), 1u);
    EXPECT_EQ(scene.parts[0].type, ShapeType::cylinder);
    EXPECT_DOUBLE_EQ(scene.shapes.cylinder[0].radius, 0.05);
    EXPECT_DOUBLE_EQ(scene.shapes.cylinder[0].height, 0.2);
    EXPECT_EQ(scene.parts[0].placement.position, glm::dvec3(1, 2, 3));
    EXPECT_EQ(scene.parts[0].node, 0u);
    EXPECT_EQ(scene.kinds[scene.parts[0].kind], "cylinder");
    EXPECT_EQ(outcome_count(scene, "cylinder", "analytic"), 1u);
}

TEST(rvm_kinds, rotation_turns_local_axes_to_the_columns) {
    // x to y, y to z, z to x.
    const Scene scene = load_one(8, {50, 200}, {0, 0.001f, 0, 0, 0, 0.001f, 0.001f, 0, 0, 0, 0, 0});
    ASSERT_EQ(scene.parts.size(), 1u);
    const glm::dvec3 z = scene.parts[0].placement.rotation * glm::dvec3(0, 0, 1);
    EXPECT_NEAR(glm::length(z - glm::dvec3(1, 0, 0)), 0.0, 1e-12);
    EXPECT_NEAR(glm::length(scene.parts[0].placement.rotation), 1.0, 1e-15);
}

TEST(rvm_kinds, any_uniform_scale_is_taken) {
    const Scene scene = load_one(8, {50, 200}, {0.5f, 0, 0, 0, 0.5f, 0, 0, 0, 0.5f, 0, 0, 0});
    ASSERT_EQ(scene.parts.size(), 1u);
    EXPECT_DOUBLE_EQ(scene.shapes.cylinder[0].radius, 25.0);
}

TEST(rvm_kinds, box_and_pyramid_keep_their_lengths) {
    const Scene box = load_one(2, {100, 200, 300});
    ASSERT_EQ(box.shapes.box.size(), 1u);
    EXPECT_DOUBLE_EQ(box.shapes.box[0].length_y, 0.2);
    const Scene pyramid = load_one(1, {100, 200, 30, 40, 5, -6, 700});
    ASSERT_EQ(pyramid.shapes.pyramid.size(), 1u);
    EXPECT_DOUBLE_EQ(pyramid.shapes.pyramid[0].top_x, 0.03);
    EXPECT_DOUBLE_EQ(pyramid.shapes.pyramid[0].offset_y, -0.006);
    EXPECT_DOUBLE_EQ(pyramid.shapes.pyramid[0].height, 0.7);
}

TEST(rvm_kinds, tori_keep_radii_and_arc) {
    const Scene round = load_one(4, {150, 50, 1.5f});
    ASSERT_EQ(round.shapes.torus.size(), 1u);
    EXPECT_DOUBLE_EQ(round.shapes.torus[0].bend_radius, 0.15);
    EXPECT_DOUBLE_EQ(round.shapes.torus[0].radius, 0.05);
    EXPECT_DOUBLE_EQ(round.shapes.torus[0].arc, 1.5);
    const Scene duct = load_one(3, {100, 300, 200, 0.75f});
    ASSERT_EQ(duct.shapes.rectangular_torus.size(), 1u);
    EXPECT_DOUBLE_EQ(duct.shapes.rectangular_torus[0].inner_radius, 0.1);
    EXPECT_DOUBLE_EQ(duct.shapes.rectangular_torus[0].height, 0.2);
    EXPECT_EQ(duct.kinds[duct.parts[0].kind], "rectangular_torus");
}

TEST(rvm_kinds, full_turn_as_a_float_is_a_full_turn) {
    const Scene scene = load_one(4, {150, 50, 6.2831855f});
    ASSERT_EQ(scene.shapes.torus.size(), 1u);
    EXPECT_EQ(scene.shapes.torus[0].arc, 2.0 * pi);
}

TEST(rvm_kinds, torus_that_touches_its_axis_is_analytic) {
    EXPECT_EQ(outcome_count(load_one(4, {50, 50, 1}), "torus", "analytic"), 1u);
}

TEST(rvm_kinds, both_dishes_are_one_kind_and_differ_in_shape) {
    const Scene elliptical = load_one(5, {100, 40});
    const Scene spherical = load_one(6, {100, 40});
    ASSERT_EQ(elliptical.shapes.dish.size(), 1u);
    ASSERT_EQ(spherical.shapes.dish.size(), 1u);
    EXPECT_EQ(elliptical.shapes.dish[0].spherical, 0.0);
    EXPECT_EQ(spherical.shapes.dish[0].spherical, 1.0);
    EXPECT_EQ(count_of(elliptical, "dish") + count_of(spherical, "dish"), 2u);
}

TEST(rvm_kinds, snout_leans_along_x_whatever_the_offset) {
    // Offset (30, 40) and shears: the world rim points must be those of the file's own frame.
    const float shears[4] = {0.1f, -0.2f, 0.3f, 0.05f};
    const Scene scene =
        load_one(7, {100, 60, 200, 30, 40, shears[0], shears[1], shears[2], shears[3]});
    ASSERT_EQ(scene.shapes.snout.size(), 1u);
    const f64::Snout& snout = scene.shapes.snout[0];
    EXPECT_NEAR(snout.offset, 0.05, 1e-12);
    for (int end = 0; end < 2; ++end) {
        const double side = end == 0 ? -1.0 : 1.0;
        const glm::dvec3 centre = side * glm::dvec3(0.015, 0.02, 0.1);
        const double slope_x = std::tan(static_cast<double>(shears[2 * end]));
        const double slope_y = std::tan(static_cast<double>(shears[2 * end + 1]));
        for (int step = 0; step < 12; ++step) {
            const glm::dvec3 local = f64().wall_point(
                snout, step * pi / 6.0, f64().end_height(snout, end, step * pi / 6.0));
            const glm::dvec3 from_centre = scene.parts[0].placement.rotation * local - centre;
            EXPECT_NEAR(from_centre.z, slope_x * from_centre.x + slope_y * from_centre.y, 1e-12);
        }
    }
}

TEST(rvm_kinds, plain_snout_is_a_cone_and_counts_as_snout) {
    const Scene scene = load_one(7, {100, 0, 200, 0, 0, 0, 0, 0, 0});
    EXPECT_EQ(scene.shapes.cone.size(), 1u);
    EXPECT_EQ(count_of(scene, "snout"), 1u);
    EXPECT_EQ(scene.kinds[scene.parts[0].kind], "snout");
}

TEST(rvm_kinds, sphere_number_is_radius_or_diameter_as_the_box_says) {
    const std::array<float, 6> box{-50, -50, -50, 50, 50, 50};
    const Scene radius = load_one(9, {50}, plain_matrix, box);
    const Scene diameter = load_one(9, {100}, plain_matrix, box);
    ASSERT_EQ(radius.shapes.sphere.size(), 1u);
    ASSERT_EQ(diameter.shapes.sphere.size(), 1u);
    EXPECT_DOUBLE_EQ(radius.shapes.sphere[0].radius, 0.05);
    EXPECT_DOUBLE_EQ(diameter.shapes.sphere[0].radius, 0.05);
}

TEST(rvm_kinds, line_is_a_hidden_rod_with_its_length_from_either_place) {
    const Scene in_b = load_one(10, {5, 100}, plain_matrix, {-5, -5, -50, 5, 5, 50});
    const Scene in_box = load_one(10, {5, 0}, plain_matrix, {-5, -5, -144.5f, 5, 5, 144.5f});
    ASSERT_EQ(in_b.shapes.cylinder.size(), 1u);
    ASSERT_EQ(in_box.shapes.cylinder.size(), 1u);
    EXPECT_DOUBLE_EQ(in_b.shapes.cylinder[0].height, 0.1);
    EXPECT_DOUBLE_EQ(in_box.shapes.cylinder[0].height, 0.289);
    EXPECT_EQ(in_b.parts[0].layer, Layer::line);
    EXPECT_EQ(in_b.kinds[in_b.parts[0].kind], "line");
    EXPECT_EQ(count_of(in_b, "cylinder"), 0u);
}

TEST(rvm_kinds, zero_sizes_become_discs_or_nothing_and_lose_nothing) {
    const Scene disc = load_one(8, {50, 0});
    EXPECT_EQ(disc.shapes.disk.size(), 1u);
    const Scene snout_disc = load_one(7, {50, 40, 0, 0, 0, 0, 0, 0, 0});
    EXPECT_EQ(snout_disc.shapes.disk.size(), 1u);
    const Scene nothing = load_one(8, {0, 100});
    EXPECT_TRUE(nothing.parts.empty());
    EXPECT_EQ(count_of(nothing, "cylinder"), 1u);
    EXPECT_EQ(outcome_count(nothing, "cylinder", "skipped"), 1u);
    EXPECT_EQ(nothing.findings.count(Severity::loss), 0u);
}

TEST(rvm_kinds, senseless_parameters_are_a_loss) {
    for (const float bad : {-50.0f, nan_value, infinity}) {
        const Scene scene = load_one(8, {bad, 100});
        EXPECT_TRUE(scene.parts.empty());
        EXPECT_EQ(scene.findings.count(Severity::loss), 1u) << bad;
        EXPECT_EQ(outcome_count(scene, "cylinder", "skipped"), 1u);
    }
    EXPECT_EQ(load_one(4, {50, 80, 1}).findings.count(Severity::loss), 1u);  // a spindle
}

TEST(rvm_kinds, matrices_that_are_not_finite_or_flatten_are_a_loss) {
    std::array<float, 12> matrix = plain_matrix;
    for (std::size_t i = 0; i < 12; ++i) {
        for (const float bad : {nan_value, infinity, -infinity}) {
            matrix = plain_matrix;
            matrix[i] = bad;
            const Scene scene = load_one(2, {100, 100, 100}, matrix);
            EXPECT_TRUE(scene.parts.empty());
            EXPECT_EQ(scene.findings.count(Severity::loss), 1u);
        }
    }
    EXPECT_TRUE(load_one(2, {100, 100, 100}, {0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1}).parts.empty());
}

double volume_of(const Mesh& mesh) {
    double volume = 0.0;
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const glm::dvec3 a(mesh.positions[mesh.indices[i]]);
        const glm::dvec3 b(mesh.positions[mesh.indices[i + 1]]);
        const glm::dvec3 c(mesh.positions[mesh.indices[i + 2]]);
        volume += glm::dot(a, glm::cross(b, c)) / 6.0;
    }
    return volume;
}

TEST(rvm_kinds, stretched_sheared_and_mirrored_parts_are_baked_inside_in) {
    const std::array<float, 12> stretched{0.002f, 0, 0, 0, 0.001f, 0, 0, 0, 0.001f, 1, 2, 3};
    const std::array<float, 12> sheared{0.001f, 0, 0, 0.0005f, 0.001f, 0, 0, 0, 0.001f, 1, 2, 3};
    const std::array<float, 12> mirrored{-0.001f, 0, 0, 0, 0.001f, 0, 0, 0, 0.001f, 1, 2, 3};
    const double cylinder = pi * 0.1 * 0.1 * 0.5;
    for (const auto& [matrix, volume] :
         {std::pair(stretched, 2.0 * cylinder), std::pair(sheared, cylinder),
          std::pair(mirrored, cylinder)}) {
        const Scene scene = load_one(8, {100, 500}, matrix);
        ASSERT_EQ(scene.parts.size(), 1u);
        EXPECT_EQ(scene.parts[0].type, ShapeType::mesh);
        EXPECT_EQ(outcome_count(scene, "cylinder", "tessellated"), 1u);
        EXPECT_GT(scene.max_deviation_m, 0.0);
        EXPECT_LT(scene.max_deviation_m, 0.01);
        EXPECT_NEAR(volume_of(scene.meshes[0]), volume, 0.02 * volume);  // positive: wound outwards
        EXPECT_NEAR(glm::length(scene.parts[0].placement.position - glm::dvec3(1, 2, 3)), 0.0,
                    1e-3);
        EXPECT_EQ(scene.findings.count(Severity::warning), 1u);
    }
}

TEST(rvm_kinds, unknown_kind_is_counted_and_lost) {
    const Scene scene = load_one(12, {1, 2, 3});
    EXPECT_EQ(count_of(scene, "unknown"), 1u);
    EXPECT_EQ(scene.findings.count(Severity::loss), 1u);
}

TEST(rvm_kinds, record_shorter_than_its_parameters_is_a_loss) {
    const Scene scene = load_one(7, {100, 60, 200});
    EXPECT_EQ(count_of(scene, "snout"), 1u);
    EXPECT_TRUE(scene.parts.empty());
    EXPECT_EQ(scene.findings.count(Severity::loss), 1u);
}

TEST(rvm_kinds, longer_record_keeps_its_primitive) {
    EXPECT_EQ(load_one(8, {50, 200, 7, 7, 7}).parts.size(), 1u);
}

RvmBytes facet_group_of(std::uint32_t polygons, std::uint32_t contours, std::uint32_t corners) {
    RvmBytes bytes;
    bytes.head().group("G").chunk("PRIM").word(11).numbers(plain_matrix).numbers(wide_box);
    bytes.word(polygons).word(contours).word(corners);
    for (const auto& [x, y] :
         {std::pair(0.0f, 0.0f), std::pair(2000.0f, 0.0f), std::pair(0.0f, 1000.0f)}) {
        bytes.numbers({x, y, 500, 0, 0, 1});
    }
    bytes.end_group();
    return bytes;
}

TEST(rvm_kinds, facet_group_is_a_mesh_around_its_own_centre) {
    Result<Scene> scene = load_bytes(facet_group_of(1, 1, 3).end());
    ASSERT_TRUE(scene.ok());
    ASSERT_EQ(scene.value().meshes.size(), 1u);
    const Mesh& mesh = scene.value().meshes[0];
    EXPECT_EQ(mesh.indices.size(), 3u);
    EXPECT_NEAR(glm::length(mesh.positions[0] - glm::vec3(-1, -0.5f, 0)), 0.0f, 1e-6f);
    EXPECT_NEAR(glm::length(scene.value().parts[0].placement.position - glm::dvec3(2, 2.5, 3.5)),
                0.0, 1e-9);
    EXPECT_EQ(outcome_count(scene.value(), "facet_group", "triangles"), 1u);
}

TEST(rvm_kinds, huge_counts_in_facet_groups_allocate_nothing) {
    for (const std::uint32_t huge : {0xffffffffu, 0x80000000u, 0x10000000u, 1000u}) {
        for (int place = 0; place < 3; ++place) {
            Result<Scene> scene = load_bytes(
                facet_group_of(place == 0 ? huge : 1, place == 1 ? huge : 1, place == 2 ? huge : 3)
                    .end());
            ASSERT_TRUE(scene.ok());
            EXPECT_TRUE(scene.value().parts.empty());
            EXPECT_EQ(count_of(scene.value(), "facet_group"), 1u);
            EXPECT_GE(scene.value().findings.count(Severity::loss), 1u);
        }
    }
}

TEST(rvm_kinds, facet_group_of_nothing_is_no_loss) {
    RvmBytes bytes;
    bytes.head().group("G").chunk("PRIM").word(11).numbers(plain_matrix).numbers(wide_box).word(0);
    Result<Scene> scene = load_bytes(bytes.end_group().end());
    ASSERT_TRUE(scene.ok());
    EXPECT_TRUE(scene.value().meshes.empty());
    EXPECT_EQ(scene.value().findings.count(Severity::loss), 0u);
}

}  // namespace
}  // namespace quartic
