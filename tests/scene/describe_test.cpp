// Parts in the words of an engineer.
#include "scene/describe.h"

#include <gtest/gtest.h>

#include <numbers>

namespace quartic {
namespace {

Scene scene_with_one_node() {
    Scene scene;
    scene.nodes.push_back({.name = scene.strings.add("PIPE-1"), .parent = no_index});
    scene.nodes.push_back({.name = scene.strings.add("ELBOW-7"), .parent = 0});
    scene.kinds = {"circular_torus"};
    scene.materials.push_back({"steel", {0.5f, 0.5f, 0.5f, 1.0f}, 0});
    return scene;
}

std::string value_of(const std::vector<Property>& list, std::string_view label) {
    for (const Property& property : list) {
        if (property.label == label) {
            return property.text;
        }
    }
    return "absent";
}

TEST(Describe, elbow_tells_its_path_diameter_bend_radius_and_angle) {
    Scene scene = scene_with_one_node();
    Part part;
    part.node = 1;
    part.placement.position = {1.2345, -2.0, 0.0};
    part.layer = Layer::insulation;
    const std::uint32_t index =
        add_part(scene, f64::Torus{0.2286, 0.08415, 0.5 * std::numbers::pi, 0.0}, part);
    const std::vector<Property> list = describe(scene, index);
    EXPECT_EQ(value_of(list, "Path"), "/PIPE-1/ELBOW-7");
    EXPECT_EQ(value_of(list, "Name"), "ELBOW-7");
    EXPECT_EQ(value_of(list, "Kind"), "circular torus");
    EXPECT_EQ(value_of(list, "Shape"), "torus");
    EXPECT_EQ(value_of(list, "Diameter"), "168.3 mm");
    EXPECT_EQ(value_of(list, "Bend radius"), "228.6 mm");
    EXPECT_EQ(value_of(list, "R/D"), "1.358");
    EXPECT_EQ(value_of(list, "Angle"), "90\u00b0");
    EXPECT_EQ(value_of(list, "Material"), "steel");
    EXPECT_EQ(value_of(list, "Layer"), "insulation");
    EXPECT_EQ(value_of(list, "Position"), "1234.5, -2000, 0 mm");
}

TEST(Describe, snout_tells_its_offset_and_only_the_cuts_it_has) {
    Scene scene = scene_with_one_node();
    const std::uint32_t index =
        add_part(scene, f64::Snout{0.1, 0.05, 0.3, 0.05, 0.0, 0.0, 1.0, 0.0}, Part{});
    const std::vector<Property> list = describe(scene, index);
    EXPECT_EQ(value_of(list, "Bottom diameter"), "200 mm");
    EXPECT_EQ(value_of(list, "Top diameter"), "100 mm");
    EXPECT_EQ(value_of(list, "Offset"), "50 mm");
    EXPECT_EQ(value_of(list, "Bottom cut"), "absent");
    EXPECT_EQ(value_of(list, "Top cut"), "45\u00b0");
}

TEST(Describe, part_without_kind_or_material_is_still_described) {
    Scene scene;
    const std::uint32_t index = add_part(scene, f64::Sphere{0.5, 0.0, 0.0, 0.0}, Part{});
    const std::vector<Property> list = describe(scene, index);
    EXPECT_EQ(value_of(list, "Kind"), "absent");
    EXPECT_EQ(value_of(list, "Diameter"), "1000 mm");
}

TEST(Describe, mesh_tells_its_triangles) {
    Scene scene;
    Mesh mesh;
    mesh.positions.resize(4);
    mesh.normals.resize(4);
    mesh.indices = {0, 1, 2, 0, 2, 3};
    const std::uint32_t index = add_mesh_part(scene, mesh, Part{});
    EXPECT_EQ(value_of(describe(scene, index), "Triangles"), "2");
}

TEST(Describe, lengths_lose_their_zeros_and_negative_zero_its_sign) {
    EXPECT_EQ(length_text(0.1), "100 mm");
    EXPECT_EQ(length_text(-0.00000001), "0 mm");
    EXPECT_EQ(length_text(12.3456789), "12345.679 mm");
    EXPECT_EQ(length_text(static_cast<double>(0.1683f)), "168.3 mm");
}

}  // namespace
}  // namespace quartic
