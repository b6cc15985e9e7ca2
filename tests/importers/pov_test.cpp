// POV-Ray scenes: what is read, where it ends up, and what is said of the rest.
#include "scene/algebraic_surface.h"
#include "tests/importers/text_models.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

namespace quartic {
namespace {

Result<Scene> load_pov(const std::string& text) {
    return load_text(text, "/nowhere/test.pov");
}

Scene scene_of(const std::string& text) {
    Result<Scene> scene = load_pov(text);
    EXPECT_TRUE(scene.ok()) << (scene ? "" : scene.error().message);
    return scene ? std::move(scene).value() : Scene();
}

bool says(const Scene& scene, Severity severity, std::string_view words) {
    for (const Finding& finding : scene.findings.list()) {
        if (finding.severity == severity && finding.text.find(words) != std::string::npos) {
            return true;
        }
    }
    return false;
}

// x^2 + 4 y^2 + 9 z^2 - 1 = 0, and a cubic term that tells x from -x.
const std::string egg =
    "cubic { <0.5,0,0,1, 0,0,0,0,0,0, 0,0,4,0,0,0, 0,9,0,-1> clipped_by { box { -2, 2 } } ";

Polynomial3 egg_polynomial() {
    const Polynomial3 x = Polynomial3::x();
    const Polynomial3 y = Polynomial3::y();
    const Polynomial3 z = Polynomial3::z();
    return 0.5 * power(x, 3) + x * x + 4 * (y * y) + 9 * (z * z) - 1;
}

// The value of the scene's surface at a point of POV-Ray's world.
double value_at(const Scene& scene, const glm::dvec3& pov) {
    const Part& part = scene.parts.at(0);
    const glm::dvec3 world(pov.x, pov.z, pov.y);
    const glm::dvec3 local =
        glm::conjugate(part.placement.rotation) * (world - part.placement.position);
    return part.type == ShapeType::cubic ? f64().value(scene.shapes.cubic.at(part.shape), local)
                                         : f64().value(scene.shapes.quartic.at(part.shape), local);
}

TEST(Pov, a_surface_keeps_its_points_when_axes_are_renamed) {
    const Scene scene = scene_of(egg + "}");
    EXPECT_EQ(scene.up_axis, "y");
    ASSERT_EQ(scene.shapes.cubic.size(), 1u);
    EXPECT_DOUBLE_EQ(scene.shapes.cubic[0].half_size, 2.0);
    for (const glm::dvec3& p : {glm::dvec3(0.1, 0.2, 0.3), glm::dvec3(-1.0, 0.7, -0.2)}) {
        EXPECT_NEAR(value_at(scene, p), egg_polynomial().value(p), 1e-12);
    }
}

TEST(Pov, transformations_apply_in_the_order_in_which_they_stand) {
    const Scene scene = scene_of(egg +
                                 "scale <2,3,0.5> rotate <0,0,90> rotate 90*y "
                                 "translate <1,2,3> }");
    // (u, v, w) -> (2u, 3v, w/2) -> (-3v, 2u, w/2) -> turned about y: (x, y, z) -> (z, y, -x).
    const auto mapped = [](const glm::dvec3& p) {
        return glm::dvec3(0.5 * p.z, 2.0 * p.x, 3.0 * p.y) + glm::dvec3(1, 2, 3);
    };
    for (const glm::dvec3& p : {glm::dvec3(0.1, 0.2, 0.3), glm::dvec3(-1.0, 0.7, -0.2)}) {
        EXPECT_NEAR(value_at(scene, mapped(p)), egg_polynomial().value(p), 1e-10);
    }
}

TEST(Pov, a_matrix_with_shear_is_folded_into_the_polynomial) {
    const Scene scene = scene_of(egg + "matrix <1,0,0, 0.5,2,0, 0,0.25,-1, 3,4,5> }");
    for (const glm::dvec3& p : {glm::dvec3(0.1, 0.2, 0.3), glm::dvec3(-1.0, 0.7, -0.2)}) {
        const glm::dvec3 q(p.x + 0.5 * p.y + 3, 2 * p.y + 0.25 * p.z + 4, -p.z + 5);
        EXPECT_NEAR(value_at(scene, q), egg_polynomial().value(p), 1e-10);
    }
}

TEST(Pov, poly_and_quadric_are_the_same_surfaces) {
    const Scene quadric = scene_of(
        "quadric { <1,2,3>, <4,5,6>, <7,8,9>, 10 clipped_by { box "
        "{ -1, 1 } } }");
    const Scene poly = scene_of("poly { 2, <1,4,5,7,2,6,8,3,9,10> clipped_by { box { -1, 1 } } }");
    ASSERT_EQ(quadric.shapes.cubic.size(), 1u);
    ASSERT_EQ(poly.shapes.cubic.size(), 1u);
    const glm::dvec3 p(0.3, -0.2, 0.5);
    const double truth = p.x * p.x + 2 * p.y * p.y + 3 * p.z * p.z + 4 * p.x * p.y + 5 * p.x * p.z +
                         6 * p.y * p.z + 7 * p.x + 8 * p.y + 9 * p.z + 10;
    EXPECT_NEAR(value_at(quadric, p), truth, 1e-12);
    EXPECT_NEAR(value_at(poly, p), truth, 1e-12);
}

TEST(Pov, a_flat_limit_is_tiled_with_cubes_that_fill_it_exactly) {
    const Scene scene = scene_of(
        "cubic { <1,0,0,0,0,0,0,0,0,0,0,0,0,0,0,-1,0,0,0,0> "
        "clipped_by { box { <-3,-2,-1>, <4,2,1> } } }");
    EXPECT_EQ(scene.parts.size(), 8u);
    const Box3 box = world_bounds(scene, {true, true, true, true});
    EXPECT_LT(glm::length(box.low - glm::dvec3(-3, -1, -2)), 1e-12);
    EXPECT_LT(glm::length(box.high - glm::dvec3(4, 1, 2)), 1e-12);
    EXPECT_FALSE(says(scene, Severity::note, "clipped"));
}

TEST(Pov, limits_are_intersections_clips_or_bounds) {
    const std::string saddle = "cubic { <1,0,0,0,-3,0,0,0,0,0,0,0,0,0,0,0,0,0,-1,0> ";
    const std::string cube = "box { -1, 1 pigment { Clear } } ";
    for (const std::string& text :
         {"intersection { " + saddle + "} object { " + cube + "scale 2 } }",
          "intersection { " + saddle + "} box { -2, 2 } plane { y, 2 } }",
          saddle + "clipped_by { " + cube + "} scale 2 }",
          saddle + "bounded_by { sphere { 0, 2 } } }",
          saddle + "clipped_by { box { -2, 2 } } bounded_by { clipped_by } }"}) {
        SCOPED_TRACE(text);
        const Scene scene = scene_of(text);
        ASSERT_EQ(scene.parts.size(), 1u);
        EXPECT_NEAR(scene.shapes.cubic.at(0).half_size, 2.0, 1e-12);
    }
    const Scene round = scene_of(saddle + "clipped_by { sphere { 0, 2 } } }");
    EXPECT_TRUE(says(round, Severity::note, "round limit"));
    const Scene none = scene_of(saddle + "}");
    EXPECT_TRUE(says(none, Severity::note, "no limits"));
    EXPECT_DOUBLE_EQ(none.shapes.cubic.at(0).half_size, 5.0);
}

TEST(Pov, a_closed_surface_without_limits_gets_a_cube_around_it) {
    const Scene scene = scene_of(
        "quartic { <4,0,0,-4,0,0,0,0,0,0, 0,0,0,0,0,0,0,0,0,0, "
        "0,0,0,0,0,1,0,0,0,0, 0,0,1,0,0> scale 10 translate 100*x }");
    const Box3 box = world_bounds(scene, {true, true, true, true});
    EXPECT_LT(box.low.x, 100.0);
    EXPECT_GT(box.high.x, 110.0);
    EXPECT_LT(scene.shapes.quartic.at(0).half_size, 10.0);
    EXPECT_FALSE(says(scene, Severity::note, "no limits"));
}

TEST(Pov, names_colours_and_arithmetic_are_understood) {
    const Scene scene = scene_of(R"(
        // comments of /* both
        /* kinds // */
        #declare R = sqrt(4)/(1+1);  #declare Tone = color rgb <0.5,0.25,1>*0.5;
        #declare Ball = sphere { <0, R*2, 0> + 2*x, -(-R) pigment { color red 0.5 } }
        #declare Plain = sphere { <0, R*2, 0> + 2*x, 1 }
        union {
            object { Ball texture { pigment { Tone } } }
            object { Plain translate <1, 2, 3>*2 texture { pigment { Tone } finish { phong 1 } } }
            sphere { 0 R pigment { rgbt <0,1,0,0.25> } }
            pigment { SteelBlue }
        }
        sphere { Nobody, 3 }
        // A lone ball
        sphere { z, 3 }
    )");
    ASSERT_EQ(scene.shapes.sphere.size(), 4u);
    EXPECT_LT(glm::length(scene.parts[0].placement.position - glm::dvec3(2, 0, 2)), 1e-12);
    EXPECT_LT(glm::length(scene.parts[1].placement.position - glm::dvec3(4, 6, 6)), 1e-12);
    const auto colour = [&](std::size_t part) {
        return scene.materials[scene.parts[part].material].colour;
    };
    EXPECT_EQ(colour(0), glm::vec4(0.5f, 0.0f, 0.0f, 1.0f));  // its own, not that around it
    EXPECT_EQ(colour(1), glm::vec4(0.25f, 0.125f, 0.5f, 1.0f));
    EXPECT_EQ(colour(2), glm::vec4(0.0f, 1.0f, 0.0f, 0.75f));
    EXPECT_EQ(path_of(scene, scene.parts[0].node), "/test.pov/Ball");
    EXPECT_EQ(path_of(scene, scene.parts[3].node), "/test.pov/A lone ball");
    EXPECT_TRUE(says(scene, Severity::loss, "sphere"));  // nobody knows Nobody
}

TEST(Pov, solids_become_shapes_where_the_transformation_allows) {
    const Scene scene = scene_of(R"(
        cylinder { <0,0,0>, <0,4,0>, 1 open scale <2,3,2> }
        cone { 0, 1, z, 0.5 rotate 90*x }
        torus { 3, 1 scale 2 }
        box { <-1,-2,-3>, <1,2,3> scale <1,2,3> rotate 30*y }
        disc { y, y, 2, 1 }
        sphere { x, 1 scale 3 }
    )");
    ASSERT_EQ(scene.parts.size(), 6u);
    EXPECT_DOUBLE_EQ(scene.shapes.cylinder.at(0).radius, 2.0);
    EXPECT_DOUBLE_EQ(scene.shapes.cylinder.at(0).height, 12.0);
    EXPECT_EQ(scene.parts[0].open_ends, 3);
    EXPECT_LT(glm::length(scene.parts[0].placement.position - glm::dvec3(0, 0, 6)), 1e-12);
    const glm::dvec3 cone_axis = scene.parts[1].placement.rotation * glm::dvec3(0, 0, 1);
    EXPECT_LT(glm::length(cone_axis - glm::dvec3(0, 0, -1)), 1e-12);  // z turns to -y, our -z
    EXPECT_DOUBLE_EQ(scene.shapes.torus.at(0).bend_radius, 6.0);
    EXPECT_NEAR(scene.shapes.box.at(0).length_z, 18.0, 1e-12);
    EXPECT_DOUBLE_EQ(scene.shapes.disk.at(0).inner_radius, 1.0);
    EXPECT_LT(glm::length(scene.parts[5].placement.position - glm::dvec3(3, 0, 0)), 1e-12);
}

TEST(Pov, stretched_solids_become_triangles_and_that_is_said) {
    const Scene scene = scene_of("sphere { 0, 1 scale <1,2,3> translate x }");
    ASSERT_EQ(scene.meshes.size(), 1u);
    EXPECT_TRUE(says(scene, Severity::warning, "stretched"));
    EXPECT_GT(scene.max_deviation_m, 0.0);
    const Box3 box = world_bounds(scene, {true, true, true, true});
    EXPECT_NEAR(box.low.x, 0.0, 0.01);
    EXPECT_NEAR(box.high.y, 3.0, 0.03);
    EXPECT_NEAR(box.high.z, 2.0, 0.02);
    for (const Outcome& outcome : scene.outcomes) {
        EXPECT_EQ(outcome.became, "tessellated");
    }
}

TEST(Pov, arcs_of_tori_are_recognised_between_planes) {
    const Scene scene = scene_of(
        "intersection { torus { 3, 1 rotate 90*x } plane { -y, 0 } plane { -x, 0 } }"
        "intersection { torus { 3, 1 rotate 90*x } union { plane { -y, 0 } plane { x, 0 } } }");
    ASSERT_EQ(scene.shapes.torus.size(), 2u);
    EXPECT_NEAR(scene.shapes.torus[0].arc, 0.5 * std::numbers::pi, 1e-12);
    EXPECT_NEAR(scene.shapes.torus[1].arc, 1.5 * std::numbers::pi, 1e-12);
    const Box3 quarter = world_bounds(scene, scene.parts[0]);
    EXPECT_LT(glm::length(quarter.low - glm::dvec3(0, -1, 0)), 1e-9);
    EXPECT_LT(glm::length(quarter.high - glm::dvec3(4, 1, 4)), 1e-9);
}

TEST(Pov, mesh2_with_and_without_normals) {
    const std::string vertices = "vertex_vectors { 3, <0,0,0>, <1,0,0>, <0,1,0> } ";
    const Scene scene = scene_of(
        "mesh2 { " + vertices + "face_indices { 1, <0,1,2> } }\n" + "mesh2 { " + vertices +
        "normal_vectors { 3, <0,0,-1>, <0,0,-1>, <0,0,-1> } face_indices { 1, <0,1,2>, 0 } }\n" +
        "mesh2 { " + vertices + "face_indices { 1, <0,1,3> } }");
    ASSERT_EQ(scene.meshes.size(), 2u);
    EXPECT_EQ(scene.meshes[1].normals[0], glm::vec3(0, -1, 0));
    EXPECT_TRUE(says(scene, Severity::loss, "corner"));
}

TEST(Pov, what_is_not_read_is_counted) {
    const Scene scene = scene_of(R"(
        camera { location <0,0,-5> } light_source { 0, 1 } light_source { x, 1 }
        plane { y, -1 } blob { threshold 0.6 sphere { 0, 1, 1 } }
        #macro A(B) sphere { B, 1 } #end
        #ifdef (Nothing) sphere { 0, 7 } #else sphere { 0, 1 } #end
        difference { box { -1, 1 } sphere { 0, 1 } }
    )");
    ASSERT_EQ(scene.shapes.sphere.size(), 1u);
    EXPECT_DOUBLE_EQ(scene.shapes.sphere[0].radius, 1.0);
    EXPECT_TRUE(says(scene, Severity::note, "light_source"));
    EXPECT_TRUE(says(scene, Severity::note, "planes"));
    EXPECT_TRUE(says(scene, Severity::loss, "blob"));
    EXPECT_TRUE(says(scene, Severity::loss, "macro"));
    EXPECT_TRUE(says(scene, Severity::loss, "solids cut by solids"));
}

TEST(Pov, thirty_four_coefficients_are_one_clear_error) {
    std::string numbers = "1";
    for (int i = 1; i < 34; ++i) {
        numbers += ",0";
    }
    const Result<Scene> scene = load_pov("\n\nquartic { <" + numbers + "> }");
    ASSERT_FALSE(scene.ok());
    EXPECT_EQ(scene.error().kind, ErrorKind::bad_data);
    EXPECT_NE(scene.error().message.find("line 3"), std::string::npos);
    EXPECT_NE(scene.error().message.find("expected 35 coefficients, found 34"), std::string::npos);
    EXPECT_EQ(scene.error().message.find('\n'), std::string::npos);
}

TEST(Pov, a_file_without_objects_is_an_error) {
    EXPECT_FALSE(load_pov("camera { location 0 }").ok());
    EXPECT_FALSE(load_pov(" ").ok());
}

}  // namespace
}  // namespace quartic
