// Groups, layers, transparency, colours and text of hand-made RVM files.
#include "tests/importers/rvm_bytes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

namespace quartic {
namespace {

Scene load_sound(std::vector<std::byte> bytes, int thread_count = 1) {
    Result<Scene> scene = load_bytes(std::move(bytes), thread_count);
    EXPECT_TRUE(scene.ok()) << (scene.ok() ? "" : scene.error().message);
    return scene.ok() ? std::move(scene).value() : Scene();
}

float alpha_of(const Scene& scene, std::size_t part) {
    return scene.materials[scene.parts[part].material].colour.a;
}

TEST(rvm_tree, groups_nest_and_positions_are_metres) {
    const Scene scene = load_sound(RvmBytes()
                                       .head()
                                       .group("/SITE")
                                       .group("/ZONE")
                                       .end_group()
                                       .group("/OTHER")
                                       .end_group()
                                       .end_group()
                                       .end());
    ASSERT_EQ(scene.nodes.size(), 3u);
    EXPECT_EQ(path_of(scene, 1), "/SITE/ZONE");
    EXPECT_EQ(path_of(scene, 2), "/SITE/OTHER");
    EXPECT_NEAR(glm::length(scene.nodes[0].position - glm::dvec3(1, 2, 3)), 0.0, 1e-12);
    EXPECT_EQ(scene.title, "/MODEL");
    EXPECT_TRUE(has_finding(scene, Severity::note, "written by tests, today"));
}

TEST(rvm_tree, surplus_end_is_a_warning_and_reading_goes_on) {
    const Scene scene = load_sound(RvmBytes()
                                       .head()
                                       .group("A")
                                       .end_group()
                                       .end_group()
                                       .end_group()
                                       .group("B")
                                       .primitive(8, {50, 100})
                                       .end_group()
                                       .end());
    EXPECT_EQ(scene.nodes.size(), 2u);
    EXPECT_EQ(scene.parts.size(), 1u);
    EXPECT_TRUE(has_finding(scene, Severity::warning, "never began"));
}

TEST(rvm_tree, primitive_outside_of_groups_gets_a_nameless_node) {
    const Scene scene = load_sound(RvmBytes()
                                       .head()
                                       .primitive(8, {50, 100})
                                       .group("A")
                                       .primitive(8, {50, 100})
                                       .end_group()
                                       .primitive(8, {50, 1})
                                       .end());
    ASSERT_EQ(scene.parts.size(), 3u);
    EXPECT_EQ(scene.strings[scene.nodes[scene.parts[0].node].name], "");
    EXPECT_EQ(scene.strings[scene.nodes[scene.parts[1].node].name], "A");
    EXPECT_EQ(scene.parts[2].node, scene.parts[0].node);
}

TEST(rvm_tree, a_million_nested_groups_load) {
    RvmBytes bytes;
    bytes.head();
    constexpr std::uint32_t depth = 1000000;
    for (std::uint32_t i = 0; i < depth; ++i) {
        bytes.group("G");
    }
    bytes.primitive(8, {50, 100});
    for (std::uint32_t i = 0; i < depth; ++i) {
        bytes.end_group();
    }
    const Scene scene = load_sound(bytes.end());
    EXPECT_EQ(scene.nodes.size(), depth);
    ASSERT_EQ(scene.parts.size(), 1u);
    EXPECT_EQ(scene.parts[0].node, depth - 1);
    EXPECT_EQ(path_of(scene, depth - 1).size(), 2u * depth);
}

RvmBytes& volume(RvmBytes& bytes, std::string_view id, bool byte_first, std::uint8_t per_cent,
                 const std::array<float, 12>& matrix = plain_matrix) {
    const std::uint32_t word = std::uint32_t{per_cent} << 24;
    bytes.chunk(id).word(8);
    if (byte_first) {
        bytes.word(word);
    }
    bytes.numbers(matrix).numbers({-50, -50, -100, 50, 50, 100});
    if (!byte_first) {
        bytes.word(word);
    }
    return bytes.numbers({50, 200});
}

TEST(rvm_tree, volumes_give_their_transparency_in_either_place) {
    for (const bool byte_first : {true, false}) {
        RvmBytes bytes;
        bytes.head().group("G");
        volume(bytes, "OBST", byte_first, 30);
        volume(bytes, "INSU", byte_first, 75);
        volume(bytes, "INSU", byte_first, 0);
        const Scene scene = load_sound(bytes.end_group().end());
        ASSERT_EQ(scene.parts.size(), 3u) << byte_first;
        EXPECT_EQ(scene.parts[0].layer, Layer::obstruction);
        EXPECT_EQ(scene.parts[1].layer, Layer::insulation);
        EXPECT_FLOAT_EQ(alpha_of(scene, 0), 0.7f);
        EXPECT_FLOAT_EQ(alpha_of(scene, 1), 0.25f);
        EXPECT_FLOAT_EQ(alpha_of(scene, 2), 1.0f);
        EXPECT_DOUBLE_EQ(scene.shapes.cylinder[0].radius, 0.05);
        EXPECT_DOUBLE_EQ(scene.shapes.cylinder[0].height, 0.2);
        EXPECT_EQ(scene.parts[1].placement.position, glm::dvec3(1, 2, 3));
        EXPECT_EQ(scene.findings.count(Severity::warning), 0u);
    }
}

TEST(rvm_tree, volume_without_a_transparency_has_its_groups) {
    RvmBytes bytes;
    bytes.head().group_with_transparency("G", 40);
    bytes.chunk("INSU")
        .word(8)
        .numbers(plain_matrix)
        .numbers({-50, -50, -100, 50, 50, 100})
        .numbers({50, 200});
    const Scene scene = load_sound(bytes.end_group().end());
    ASSERT_EQ(scene.parts.size(), 1u);
    EXPECT_FLOAT_EQ(alpha_of(scene, 0), 0.6f);
}

TEST(rvm_tree, primitives_and_groups_inherit_transparency_in_every_group_version) {
    for (const std::uint32_t version : {3u, 4u}) {
        RvmBytes bytes;
        bytes.head().group_with_transparency("G", 40, version).primitive(8, {50, 100});
        bytes.group("H").primitive(8, {50, 100}).end_group();
        bytes.group_with_transparency("I", 10, version).primitive(8, {50, 100}).end_group();
        const Scene scene =
            load_sound(bytes.end_group().group("J").primitive(8, {50, 100}).end_group().end());
        ASSERT_EQ(scene.parts.size(), 4u);
        EXPECT_FLOAT_EQ(alpha_of(scene, 0), 0.6f);
        EXPECT_FLOAT_EQ(alpha_of(scene, 1), 0.6f);
        EXPECT_FLOAT_EQ(alpha_of(scene, 2), 0.9f);
        EXPECT_FLOAT_EQ(alpha_of(scene, 3), 1.0f);
        EXPECT_EQ(scene.findings.count(Severity::loss), 0u);
    }
}

TEST(rvm_tree, colours_hold_wherever_they_stand) {
    for (const bool after : {true, false}) {
        RvmBytes bytes;
        bytes.head();
        if (!after) {
            bytes.colour(49, 255, 0, 188);
        }
        bytes.group("G", 49).primitive(8, {50, 100}).end_group();
        if (after) {
            bytes.colour(49, 255, 0, 188);
        }
        const Scene scene = load_sound(bytes.end());
        ASSERT_EQ(scene.materials.size(), 1u);
        const glm::vec4 colour = scene.materials[0].colour;
        EXPECT_FLOAT_EQ(colour.r, 1.0f);
        EXPECT_FLOAT_EQ(colour.g, 0.0f);
        EXPECT_NEAR(colour.b, 0.50289f, 1e-4f);  // linear of sRGB 188
    }
}

TEST(rvm_tree, palette_colours_are_red_and_blue_and_others_differ) {
    RvmBytes bytes;
    bytes.head();
    for (const std::uint32_t index : {2u, 7u, 200u, 201u}) {
        bytes.group("G", index).primitive(8, {50, 100}).end_group();
    }
    const Scene scene = load_sound(bytes.end());
    ASSERT_EQ(scene.materials.size(), 4u);
    EXPECT_EQ(scene.materials[0].colour, glm::vec4(1, 0, 0, 1));
    EXPECT_EQ(scene.materials[1].colour, glm::vec4(0, 0, 1, 1));
    EXPECT_GT(glm::length(scene.materials[2].colour - scene.materials[3].colour), 0.1f);
}

TEST(rvm_tree, one_material_for_each_colour_transparency_and_layer) {
    RvmBytes bytes;
    bytes.head().group("G", 2).primitive(8, {50, 100}).primitive(8, {60, 100});
    volume(bytes, "OBST", true, 0);
    bytes.end_group().group("H", 2).primitive(8, {50, 100}).end_group();
    const Scene scene = load_sound(bytes.end());
    EXPECT_EQ(scene.materials.size(), 2u);
    EXPECT_EQ(scene.parts[0].material, scene.parts[3].material);
    EXPECT_NE(scene.parts[0].material, scene.parts[2].material);
}

TEST(rvm_tree, text_before_version_2_is_latin_1) {
    const Scene scene = load_sound(RvmBytes().head(1).group("R\xf6hre").end_group().end());
    EXPECT_EQ(scene.strings[scene.nodes[0].name], "R\xc3\xb6hre");
}

TEST(rvm_tree, damaged_utf_8_is_replaced) {
    const Scene scene = load_sound(RvmBytes()
                                       .head(2)
                                       .group("a\xffz\xe4\xb8")
                                       .group("\xe4\xb8\xad")
                                       .end_group()
                                       .end_group()
                                       .end());
    EXPECT_EQ(scene.strings[scene.nodes[0].name], "a\xef\xbf\xbdz\xef\xbf\xbd\xef\xbf\xbd");
    EXPECT_EQ(scene.strings[scene.nodes[1].name], "\xe4\xb8\xad");
}

TEST(rvm_tree, unknown_chunk_is_skipped_with_a_warning) {
    RvmBytes bytes;
    bytes.head().group("G").chunk("XYZW").numbers({1, 2, 3});
    const Scene scene = load_sound(bytes.primitive(8, {50, 100}).end_group().end());
    EXPECT_EQ(scene.parts.size(), 1u);
    EXPECT_TRUE(has_finding(scene, Severity::warning, "unknown chunk"));
}

// Everything of a scene that an importer fills, as bytes.
std::string dump(const Scene& scene) {
    std::string bytes;
    const auto append = [&](const auto& array) {
        using Item = typename std::decay_t<decltype(array)>::value_type;
        bytes.append(reinterpret_cast<const char*>(array.data()), array.size() * sizeof(Item));
    };
    for (const Part& part : scene.parts) {
        const double placement[7] = {part.placement.position.x, part.placement.position.y,
                                     part.placement.position.z, part.placement.rotation.x,
                                     part.placement.rotation.y, part.placement.rotation.z,
                                     part.placement.rotation.w};
        bytes.append(reinterpret_cast<const char*>(placement), sizeof placement);
        const std::uint32_t numbers[6] = {part.node,  part.material,
                                          part.shape, static_cast<std::uint32_t>(part.type),
                                          part.kind,  static_cast<std::uint32_t>(part.layer)};
        bytes.append(reinterpret_cast<const char*>(numbers), sizeof numbers);
    }
    append(scene.shapes.cylinder);
    append(scene.shapes.box);
    append(scene.shapes.disk);
    append(scene.kind_counts);
    for (const Mesh& mesh : scene.meshes) {
        append(mesh.positions);
        append(mesh.indices);
    }
    for (const Material& material : scene.materials) {
        bytes += material.name + '\n';
    }
    for (const Outcome& outcome : scene.outcomes) {
        bytes +=
            outcome.kind + outcome.became + outcome.reason + std::to_string(outcome.count) + '\n';
    }
    for (const Finding& finding : scene.findings.list()) {
        bytes += finding.where + finding.text + std::to_string(finding.count) + '\n';
    }
    return bytes;
}

TEST(rvm_tree, scene_is_the_same_for_any_number_of_threads) {
    RvmBytes bytes;
    bytes.head();
    const std::array<float, 12> mirrored{-0.001f, 0, 0, 0, 0.001f, 0, 0, 0, 0.001f, 1, 2, 3};
    for (std::uint32_t i = 0; i < 40000; ++i) {
        const auto size = static_cast<float>(i % 100);
        bytes.group("G", i % 37);
        bytes.primitive(8, {size, static_cast<float>(i % 7)}).primitive(2, {size, 10, 20});
        if (i % 1000 == 0) {
            bytes.primitive(2, {10, 20, 30}, mirrored).primitive(8, {-1, 5});
        }
        bytes.end_group();
    }
    const std::vector<std::byte> file = bytes.end();
    const std::string expected = dump(load_sound(file, 1));
    EXPECT_GT(expected.size(), 1000000u);
    for (const int threads : {2, 3, 8}) {
        EXPECT_EQ(dump(load_sound(file, threads)), expected) << threads;
    }
}

}  // namespace
}  // namespace quartic
