// Scenes written for POV-Ray and read again: the same numbers, the same picture.
#include "exporters/pov.h"

#include "exporters/save.h"
#include "generators/generate.h"
#include "importers/load.h"
#include "scene/algebraic_surface.h"
#include "scene/reference.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace quartic {
namespace {

std::vector<std::byte> bytes_of(const Scene& scene) {
    std::vector<std::byte> bytes;
    Output output = Output::to_memory(bytes);
    EXPECT_TRUE(export_pov(scene, output).ok());
    EXPECT_TRUE(output.commit().ok());
    return bytes;
}

Scene read_back(const Scene& scene) {
    Progress progress;
    const Source source = Source::from_bytes("/nowhere/written.pov", bytes_of(scene));
    Result<Scene> loaded = load_scene(source, ImportOptions{}, progress);
    EXPECT_TRUE(loaded.ok()) << (loaded ? "" : loaded.error().message);
    return loaded ? std::move(loaded).value() : Scene();
}

Scene gallery_scene() {
    Result<Scene> scene = generate("surfaces", {});
    EXPECT_TRUE(scene.ok());
    return scene ? std::move(scene).value() : Scene();
}

// One of everything, turned.
Scene everything() {
    Scene scene;
    scene.title = "everything";
    scene.materials.push_back({"steel", {0.2f, 0.4f, 0.6f, 1.0f}, 0});
    scene.materials.push_back({"glass\nof two lines", {0.9f, 0.1f, 0.1f, 0.25f}, 0});
    Node node;
    node.name = scene.strings.add("/PIPE-1");
    scene.nodes.push_back(node);
    Part part;
    part.placement.rotation = glm::normalize(glm::dquat(0.8, 0.1, -0.3, 0.5));
    part.placement.position = {12.5, -7.25, 3.125};
    const double turn = 2.0 * std::numbers::pi;
    const auto add = [&](const auto& shape) {
        EXPECT_TRUE(add_shape(scene, shape, part).drawn);
        part.placement.position.x += 1.5;
    };
    add(f64::Sphere{0.4, 0, 0, 0});
    add(f64::Cylinder{0.3, 0.5, 0, 0});
    add(f64::Cone{0.3, 0.2, 0.5, 0});
    add(f64::Cone{0.3, 0.0, 0.5, 0});
    add(f64::Box{0.1, 0.2, 0.3, 0});
    add(f64::Disk{0.4, 0.2, 0, 0});
    for (const double arc : {0.7, 0.5 * turn, 4.5, turn}) {
        add(f64::Torus{0.3, 0.1, arc, 0});
    }
    part.material = 1;
    add(f64::Dish{0.5, 0.2, 0, 0});
    add(f64::Snout{0.3, 0.2, 0.5, 0.1, 0.2, -0.1, 0.3, 0.15});
    add(f64::RectangularTorus{0.3, 0.5, 0.2, 1.5});
    add(f64::Pyramid{0.5, 0.4, 0.3, 0.2, 0.1, -0.1, 0.6, 0});
    return scene;
}

// Rays from all sides at each part's box give the same hits.
void expect_same_picture(const Scene& a, const Scene& b, double tolerance, double grazing) {
    const std::array<bool, layer_count> layers{true, true, true, true};
    const Reference first(a, layers);
    const Reference second(b, layers);
    int hits = 0;
    int different = 0;
    for (const Part& part : a.parts) {
        const Box3 box = world_bounds(a, part);
        const double size = glm::length(box.high - box.low);
        for (int i = 0; i < 400; ++i) {
            const double angle = 2.399963 * i;
            const double z = 1.0 - (2.0 * i + 1.0) / 400.0;
            const double rho = std::sqrt(1.0 - z * z);
            const glm::dvec3 out(rho * std::cos(angle), rho * std::sin(angle), z);
            const glm::dvec3 aim =
                glm::mix(box.low, box.high, glm::dvec3(0.5 + 0.3 * std::sin(7.0 * i)));
            f64::Ray ray{};
            ray.origin = aim + 2.0 * size * out;
            ray.direction = -out;
            const ReferenceHit hit = first.trace(ray);
            const ReferenceHit again = second.trace(ray);
            hits += hit.part != no_index;
            different +=
                (hit.part != no_index) != (again.part != no_index) ||
                (hit.part != no_index &&
                 std::abs(hit.t - again.t) * std::abs(glm::dot(hit.normal, out)) > tolerance);
        }
    }
    EXPECT_GT(hits, static_cast<int>(100 * a.parts.size()));
    EXPECT_LE(different, grazing * hits);
}

TEST(ExportPov, the_gallery_comes_back_with_the_same_coefficients) {
    const Scene scene = gallery_scene();
    const Scene read = read_back(scene);
    ASSERT_EQ(read.shapes.cubic.size(), scene.shapes.cubic.size());
    ASSERT_EQ(read.shapes.quartic.size(), scene.shapes.quartic.size());
    const auto expect_same = [](const auto& written, const auto& again) {
        const Polynomial3 a = polynomial_of(written);
        const Polynomial3 b = polynomial_of(again);
        for (std::size_t i = 0; i < Polynomial3::term_count; ++i) {
            EXPECT_NEAR(a.terms()[i], b.terms()[i], 1e-12 * std::abs(a.terms()[i])) << i;
        }
        EXPECT_NEAR(written.half_size, again.half_size, 1e-12 * written.half_size);
    };
    for (std::size_t i = 0; i < scene.shapes.cubic.size(); ++i) {
        expect_same(scene.shapes.cubic[i], read.shapes.cubic[i]);
    }
    for (std::size_t i = 0; i < scene.shapes.quartic.size(); ++i) {
        expect_same(scene.shapes.quartic[i], read.shapes.quartic[i]);
    }
    EXPECT_EQ(path_of(read, read.parts[0].node), "/written.pov/Cayley cubic");
    EXPECT_EQ(read.findings.count(Severity::loss), 0u);
    EXPECT_EQ(read.findings.count(Severity::warning), 0u);
}

TEST(ExportPov, the_gallery_comes_back_as_the_same_picture) {
    const Scene scene = gallery_scene();
    expect_same_picture(scene, read_back(scene), 1e-9, 0.002);
}

TEST(ExportPov, turned_surfaces_come_back_as_the_same_picture) {
    Scene scene = gallery_scene();
    for (std::size_t i = 0; i < scene.parts.size(); ++i) {
        const double turn = 0.37 * static_cast<double>(i + 1);
        scene.parts[i].placement.rotation =
            glm::angleAxis(turn, glm::normalize(glm::dvec3(1.0, 2.0, -0.5)));
    }
    expect_same_picture(scene, read_back(scene), 1e-9, 0.002);
}

TEST(ExportPov, exact_shapes_come_back_as_shapes_and_the_others_as_triangles) {
    const Scene scene = everything();
    const Scene read = read_back(scene);
    ASSERT_EQ(read.parts.size(), scene.parts.size());
    for (std::size_t i = 0; i < scene.parts.size(); ++i) {
        const ShapeType type = scene.parts[i].type;
        const bool exact = type != ShapeType::dish && type != ShapeType::snout &&
                           type != ShapeType::rectangular_torus && type != ShapeType::pyramid;
        EXPECT_EQ(read.parts[i].type, exact ? type : ShapeType::mesh) << i;
        const glm::vec4 colour = read.materials[read.parts[i].material].colour;
        EXPECT_LT(glm::length(colour - scene.materials[scene.parts[i].material].colour), 1e-6f);
    }
    EXPECT_EQ(read.findings.count(Severity::loss), 0u);
    EXPECT_EQ(read.findings.count(Severity::warning), 0u);
    expect_same_picture(scene, read, 0.002, 0.01);
}

TEST(ExportPov, arcs_come_back_to_double_precision) {
    const Scene scene = everything();
    const Scene read = read_back(scene);
    ASSERT_EQ(read.shapes.torus.size(), 4u);
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_NEAR(read.shapes.torus[i].arc, scene.shapes.torus[i].arc, 1e-9);
    }
}

TEST(ExportPov, the_same_scene_gives_the_same_bytes) {
    EXPECT_EQ(bytes_of(everything()), bytes_of(everything()));
}

TEST(ExportPov, what_is_not_exact_is_said) {
    EXPECT_EQ(export_findings(everything(), "a.pov").list().size(), 1u);
    EXPECT_EQ(export_findings(gallery_scene(), "a.pov").list().size(), 0u);
    EXPECT_EQ(export_findings(gallery_scene(), "a.rvm").count(Severity::warning), 16u);
    EXPECT_EQ(export_findings(gallery_scene(), "-").count(Severity::warning), 16u);
    EXPECT_EQ(export_findings(everything(), "a.rvm").list().size(), 0u);
}

TEST(ExportRvm, surfaces_become_facets) {
    std::vector<std::byte> bytes;
    Output output = Output::to_memory(bytes);
    const Scene scene = gallery_scene();
    ASSERT_TRUE(find_exporter("a.rvm")->save(scene, output).ok());
    ASSERT_TRUE(output.commit().ok());
    Progress progress;
    const Result<Scene> read =
        load_scene(Source::from_bytes("a.rvm", std::move(bytes)), ImportOptions{}, progress);
    ASSERT_TRUE(read.ok());
    ASSERT_EQ(read.value().meshes.size(), 16u);
    for (std::size_t i = 0; i < 16; ++i) {
        EXPECT_GT(read.value().meshes[i].indices.size(), 1000u);
        const Box3 box = world_bounds(read.value(), read.value().parts[i]);
        const Box3 cube = world_bounds(scene, scene.parts[i]);
        EXPECT_LT(glm::length(glm::max(cube.low - box.low, glm::dvec3(0.0))), 1e-3);
        EXPECT_LT(glm::length(glm::max(box.high - cube.high, glm::dvec3(0.0))), 1e-3);
    }
}

}  // namespace
}  // namespace quartic
