// Scenes written as RVM and read again: the same shapes to float precision, the same tree, the same
// bytes.
#include "exporters/rvm.h"

#include "exporters/save.h"
#include "importers/load.h"
#include "scene/add_shape.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <numbers>

#include <unistd.h>

namespace quartic {
namespace {

std::string temporary_path(const std::string& name) {
    return (std::filesystem::temp_directory_path() /
            (name + std::to_string(::testing::UnitTest::GetInstance()->random_seed()) + "_" +
             std::to_string(getpid()) + ".rvm"))
        .string();
}

std::vector<std::byte> bytes_of(const Scene& scene, const std::string& name) {
    const std::string path = temporary_path(name);
    const Status saved = save_scene(scene, path);
    EXPECT_TRUE(saved.ok()) << (saved ? "" : saved.error().message);
    Result<Source> source = Source::open(path);
    EXPECT_TRUE(source.ok());
    const std::vector<std::byte> bytes(source.value().bytes().begin(),
                                       source.value().bytes().end());
    std::filesystem::remove(path);
    return bytes;
}

Scene read_back(const Scene& scene, const std::string& name) {
    Progress progress;
    const Source source = Source::from_bytes(name + ".rvm", bytes_of(scene, name));
    Result<Scene> loaded = load_scene(source, ImportOptions{}, progress);
    EXPECT_TRUE(loaded.ok()) << (loaded ? "" : loaded.error().message);
    return loaded ? std::move(loaded).value() : Scene();
}

std::uint32_t add_node(Scene& scene, std::string_view name, std::uint32_t parent,
                       glm::dvec3 position) {
    Node node;
    node.name = scene.strings.add(name);
    node.parent = parent;
    node.position = position;
    scene.nodes.push_back(node);
    return static_cast<std::uint32_t>(scene.nodes.size() - 1);
}

// One of everything, turned, in a tree of two levels.
Scene everything() {
    Scene scene;
    scene.title = "everything";
    scene.materials.push_back({"steel", {0.2f, 0.4f, 0.6f, 1.0f}, 0});
    scene.materials.push_back({"glass", {0.9f, 0.1f, 0.1f, 0.4f}, 0});
    const std::uint32_t root = add_node(scene, "/SITE", no_index, {1.0, 2.0, 3.0});
    Part part;
    part.node = add_node(scene, "/PIPE-1", root, {10.0, -20.0, 30.0});
    part.placement.rotation = glm::normalize(glm::dquat(0.8, 0.1, -0.3, 0.5));
    part.placement.position = {12.5, -7.25, 3.125};
    const double turn = 2.0 * std::numbers::pi;
    const auto add = [&](const auto& shape) {
        EXPECT_TRUE(add_shape(scene, shape, part).drawn);
        part.placement.position.x += 1.0;
    };
    add(f64::Pyramid{0.5, 0.4, 0.3, 0.2, 0.1, -0.1, 0.6, 0});
    add(f64::Box{0.1, 0.2, 0.3, 0});
    add(f64::RectangularTorus{0.3, 0.5, 0.2, 1.5});
    add(f64::RectangularTorus{0.3, 0.5, 0.2, turn});
    add(f64::Torus{0.3, 0.1, 0.7, 0});
    add(f64::Torus{0.3, 0.1, turn, 0});
    add(f64::Dish{0.5, 0.2, 0, 0});
    add(f64::Dish{0.5, 0.7, 1, 0});
    add(f64::Snout{0.3, 0.2, 0.5, 0.1, 0.2, -0.1, 0.3, 0.15});
    add(f64::Snout{0.3, 0.2, 0.5, -0.1, 0, 0, 0, 0});
    add(f64::Cone{0.3, 0.2, 0.5, 0});
    add(f64::Cylinder{0.3, 0.5, 0, 0});
    add(f64::Sphere{0.4, 0, 0, 0});
    add(f64::Disk{0.4, 0, 0, 0});
    part.node = add_node(scene, "/EQUIPMENT", root, glm::dvec3(0.0));
    part.material = 1;
    part.layer = Layer::insulation;
    add(f64::Cylinder{0.35, 0.5, 0, 0});
    part.layer = Layer::obstruction;
    add(f64::Box{1.0, 1.0, 1.0, 0});
    part.layer = Layer::line;
    add(f64::Cylinder{0.002, 1.5, 0, 0});
    return scene;
}

template <class Shape>
void expect_same_shapes(const std::vector<Shape>& written, const std::vector<Shape>& read,
                        std::string_view name) {
    ASSERT_EQ(written.size(), read.size()) << name;
    for (std::size_t i = 0; i < written.size(); ++i) {
        const f64::Bounds a = f64().bounds(written[i]);
        const f64::Bounds b = f64().bounds(read[i]);
        const double size = glm::length(a.high - a.low);
        EXPECT_LT(glm::length(a.low - b.low), 3e-7 * size) << name << ' ' << i;
        EXPECT_LT(glm::length(a.high - b.high), 3e-7 * size) << name << ' ' << i;
        for (const double u : {0.1, 0.6}) {
            for (int face = 0; face < f64().face_count(written[i]); ++face) {
                const glm::dvec3 p = f64().point(written[i], face, {u, 0.3});
                EXPECT_LT(glm::length(p - f64().point(read[i], face, {u, 0.3})), 3e-6 * size)
                    << name << ' ' << i;
            }
        }
    }
}

TEST(ExportRvm, shapes_come_back_to_float_precision) {
    Scene scene = everything();
    const Scene read = read_back(scene, "everything");
    // A snout that leans along -x comes back turned by half a turn, leaning along +x: the same
    // solid.
    scene.shapes.snout.pop_back();
    std::vector<f64::Snout> snouts = read.shapes.snout;
    ASSERT_EQ(snouts.size(), 2u);
    EXPECT_NEAR(snouts[1].offset, 0.1, 1e-7);
    snouts.pop_back();
    expect_same_shapes(scene.shapes.snout, snouts, "snout");
    expect_same_shapes(scene.shapes.pyramid, read.shapes.pyramid, "pyramid");
    expect_same_shapes(scene.shapes.box, read.shapes.box, "box");
    expect_same_shapes(scene.shapes.rectangular_torus, read.shapes.rectangular_torus, "duct");
    expect_same_shapes(scene.shapes.torus, read.shapes.torus, "torus");
    expect_same_shapes(scene.shapes.dish, read.shapes.dish, "dish");
    expect_same_shapes(scene.shapes.cone, read.shapes.cone, "cone");
    expect_same_shapes(scene.shapes.cylinder, read.shapes.cylinder, "cylinder");
    expect_same_shapes(scene.shapes.sphere, read.shapes.sphere, "sphere");
    expect_same_shapes(scene.shapes.disk, read.shapes.disk, "disk");
}

TEST(ExportRvm, places_layers_and_colours_come_back) {
    const Scene scene = everything();
    const Scene read = read_back(scene, "places");
    ASSERT_EQ(scene.parts.size(), read.parts.size());
    for (std::size_t i = 0; i < scene.parts.size(); ++i) {
        const Box3 a = world_bounds(scene, scene.parts[i]);
        const Box3 b = world_bounds(read, read.parts[i]);
        EXPECT_LT(glm::length(a.low - b.low), 2e-5) << i;
        EXPECT_LT(glm::length(a.high - b.high), 2e-5) << i;
        EXPECT_EQ(scene.parts[i].layer, read.parts[i].layer) << i;
        const glm::vec4 colour = read.materials[read.parts[i].material].colour;
        const glm::vec4 wanted = scene.materials[scene.parts[i].material].colour;
        EXPECT_LT(glm::length(colour - wanted), 0.02f) << i;
    }
}

TEST(ExportRvm, the_tree_comes_back) {
    const Scene scene = everything();
    const Scene read = read_back(scene, "tree");
    ASSERT_EQ(read.nodes.size(), 3u);
    for (std::uint32_t i = 0; i < 3; ++i) {
        EXPECT_EQ(path_of(scene, i), path_of(read, i));
        EXPECT_LT(glm::length(scene.nodes[i].position - read.nodes[i].position), 1e-5);
    }
}

TEST(ExportRvm, nothing_is_noticed_when_our_own_file_is_read) {
    const Scene read = read_back(everything(), "findings");
    for (const Finding& finding : read.findings.list()) {
        EXPECT_EQ(finding.severity, Severity::note) << finding.text;
    }
}

TEST(ExportRvm, the_same_scene_gives_the_same_bytes) {
    EXPECT_EQ(bytes_of(everything(), "one"), bytes_of(everything(), "two"));
}

TEST(ExportRvm, the_file_is_a_multiple_of_480_bytes) {
    EXPECT_EQ(bytes_of(everything(), "blocks").size() % 480, 0u);
}

TEST(ExportRvm, a_mesh_becomes_a_facet_group) {
    Scene scene;
    scene.materials.push_back({});
    Part part;
    part.node = add_node(scene, "/MESH", no_index, glm::dvec3(0.0));
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    mesh.normals = std::vector<glm::vec3>(4, glm::vec3(0, 0, 1));
    mesh.indices = {0, 1, 2, 0, 1, 3};
    add_mesh_part(scene, mesh, part);
    const Scene read = read_back(scene, "mesh");
    ASSERT_EQ(read.meshes.size(), 1u);
    EXPECT_EQ(read.meshes[0].indices.size(), 6u);
    const Box3 box = world_bounds(read, read.parts[0]);
    EXPECT_LT(glm::length(box.high - glm::dvec3(1.0)), 1e-5);
}

TEST(ExportRvm, parts_of_another_material_get_a_group_of_their_own) {
    Scene scene;
    scene.materials.push_back({"red", {1, 0, 0, 1}, 0});
    scene.materials.push_back({"green", {0, 1, 0, 1}, 0});
    Part part;
    part.node = add_node(scene, "/MIXED", no_index, glm::dvec3(0.0));
    for (const std::uint32_t material : {0u, 1u, 0u}) {
        part.material = material;
        add_shape(scene, f64::Sphere{1.0, 0, 0, 0}, part);
    }
    const Scene read = read_back(scene, "mixed");
    ASSERT_EQ(read.parts.size(), 3u);
    EXPECT_EQ(read.nodes.size(), 2u);
    EXPECT_EQ(path_of(read, read.parts[1].node), "/MIXED/green");
    EXPECT_GT(read.materials[read.parts[1].material].colour.g, 0.9f);
    EXPECT_GT(read.materials[read.parts[2].material].colour.r, 0.9f);
}

TEST(ExportRvm, a_deep_tree_needs_no_stack) {
    Scene scene;
    std::uint32_t parent = no_index;
    for (int i = 0; i < 200000; ++i) {
        parent = add_node(scene, "A", parent, glm::dvec3(0.0));
    }
    EXPECT_GT(bytes_of(scene, "deep").size(), 200000u * 48u);
}

}  // namespace
}  // namespace quartic
