// All kinds of models: sound shapes, counts as asked, the same bytes again.
#include "generators/generate.h"

#include "exporters/pov.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace quartic {
namespace {

Scene make(std::string_view kind, const GenerateOptions& options) {
    Result<Scene> scene = generate(kind, options);
    EXPECT_TRUE(scene.ok()) << (scene ? "" : scene.error().message);
    return scene ? std::move(scene).value() : Scene();
}

// POV-Ray's language holds doubles to the last digit.
std::vector<std::byte> bytes_of(const Scene& scene) {
    std::vector<std::byte> bytes;
    Output output = Output::to_memory(bytes);
    EXPECT_TRUE(export_pov(scene, output).ok());
    EXPECT_TRUE(output.commit().ok());
    return bytes;
}

GenerateOptions with_count(std::uint64_t count, std::uint64_t seed = 1) {
    GenerateOptions options;
    options.count = count;
    options.seed = seed;
    return options;
}

TEST(Generate, every_kind_makes_parts_without_fault) {
    for (const GeneratorRow& row : generator_table()) {
        SCOPED_TRACE(row.name);
        const Scene scene = make(row.name, {});
        EXPECT_GT(scene.parts.size(), 4u);
        for (const Part& part : scene.parts) {
            ASSERT_LT(part.node, scene.nodes.size());
            ASSERT_LT(part.material, scene.materials.size());
            ASSERT_LT(part.kind, scene.kinds.size());
            ASSERT_NEAR(glm::length(part.placement.rotation), 1.0, 1e-12);
            visit_shape(scene.shapes, part.type, part.shape,
                        [](const auto& shape) { ASSERT_EQ(find_fault(shape), ""); });
        }
    }
}

TEST(Generate, parents_stand_before_their_children) {
    for (const GeneratorRow& row : generator_table()) {
        const Scene scene = make(row.name, {});
        for (std::uint32_t i = 0; i < scene.nodes.size(); ++i) {
            ASSERT_TRUE(scene.nodes[i].parent == no_index || scene.nodes[i].parent < i);
        }
    }
}

TEST(Generate, counts_are_within_a_tenth_of_what_was_asked) {
    for (const GeneratorRow& row : generator_table()) {
        for (const std::uint64_t count : {10u, 100u, 1000u, 7777u, 50000u}) {
            if (row.count_default > 0) {
                const double made = double(make(row.name, with_count(count)).parts.size());
                EXPECT_NEAR(made / double(count), 1.0, 0.1) << row.name << ' ' << count;
            }
        }
    }
}

TEST(Generate, shapes_are_as_many_as_parts) {
    const Scene scene = make("plant", with_count(5000));
    std::size_t shapes = 0;
#define SHAPE(id, Type, name) shapes += scene.shapes.name.size();
#include "primitives/catalog.h"
#undef SHAPE
    EXPECT_EQ(shapes, scene.parts.size());
}

TEST(Generate, the_same_seed_gives_the_same_bytes_and_another_one_does_not) {
    for (const GeneratorRow& row : generator_table()) {
        const GenerateOptions options = with_count(row.count_default > 0 ? 3000 : 0);
        EXPECT_EQ(bytes_of(make(row.name, options)), bytes_of(make(row.name, options))) << row.name;
        if (row.count_default > 0) {
            EXPECT_NE(bytes_of(make(row.name, options)),
                      bytes_of(make(row.name, with_count(3000, 2))));
        }
    }
}

TEST(Generate, the_offset_moves_everything_in_double) {
    GenerateOptions options = with_count(500);
    const Scene here = make("plant", options);
    options.offset = {1e7, -2e7, 300.0};
    const Scene there = make("plant", options);
    ASSERT_EQ(here.parts.size(), there.parts.size());
    for (std::size_t i = 0; i < here.parts.size(); ++i) {
        const glm::dvec3 moved =
            there.parts[i].placement.position - here.parts[i].placement.position;
        ASSERT_LT(glm::length(moved - options.offset), 1e-8);
    }
    EXPECT_LT(glm::length(there.nodes[0].position - here.nodes[0].position - options.offset), 1e-8);
}

TEST(Generate, the_extent_sets_the_side_length) {
    GenerateOptions options = with_count(8000);
    options.extent_m = 500.0;
    for (const char* kind : {"tori", "elbows"}) {
        const Box3 box = world_bounds(make(kind, options), {true, true, true, true});
        EXPECT_NEAR(box.high.x - box.low.x, 500.0, 40.0) << kind;
    }
    options.count = 20000;
    options.extent_m = 1000.0;
    const Box3 box = world_bounds(make("plant", options), {true, true, true, true});
    EXPECT_GT(box.high.x - box.low.x, 600.0);
    EXPECT_LT(box.high.x - box.low.x, 1010.0);
}

TEST(Generate, an_unknown_kind_is_a_usage_error_that_names_the_known_ones) {
    const Result<Scene> scene = generate("castle", {});
    ASSERT_FALSE(scene.ok());
    EXPECT_EQ(scene.error().kind, ErrorKind::usage);
    EXPECT_NE(scene.error().message.find("plant"), std::string::npos);
}

TEST(Generate, senseless_options_are_refused) {
    EXPECT_FALSE(generate("tori", with_count(std::uint64_t{1} << 60)).ok());
    GenerateOptions options;
    options.extent_m = -1.0;
    EXPECT_FALSE(generate("tori", options).ok());
    options.extent_m = std::nan("");
    EXPECT_FALSE(generate("tori", options).ok());
    options.extent_m = 0.0;
    options.offset.x = std::nan("");
    EXPECT_FALSE(generate("tori", options).ok());
}

TEST(Generate, the_sheet_has_every_type_of_solid_under_names_of_their_own) {
    const Scene scene = make("sheet", {});
    std::set<ShapeType> types;
    for (const Part& part : scene.parts) {
        types.insert(part.type);
    }
    for (const ShapeRow& shape : shape_table()) {
        EXPECT_EQ(types.contains(shape.type), !shape.implicit) << shape.name;
    }
    std::set<std::string> names;
    for (const Node& node : scene.nodes) {
        EXPECT_TRUE(names.insert(std::string(scene.strings[node.name])).second)
            << scene.strings[node.name];
    }
}

}  // namespace
}  // namespace quartic
