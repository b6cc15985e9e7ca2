// Real files: counts, both forms against each other, attributes.
#include "importers/load.h"
#include "importers/rvm_chunks.h"
#include "tests/importers/model_files.h"
#include "tests/importers/rvm_bytes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace quartic {
namespace {

Scene load_real(const std::string& path, const ImportOptions& options = {}) {
    Progress progress;
    Result<Scene> scene = load_scene(path, options, progress);
    EXPECT_TRUE(scene.ok()) << (scene.ok() ? "" : scene.error().message);
    return scene.ok() ? std::move(scene).value() : Scene();
}

TEST(rvm_files, huldra_piping_has_the_known_counts) {
    const std::string path = test_data("rvm/HA-PIPE.RVM");
    SKIP_WITHOUT(path);
    const Scene scene = load_real(path);
    EXPECT_EQ(count_of(scene, "cylinder"), 1091u);
    EXPECT_EQ(count_of(scene, "snout"), 320u);
    EXPECT_EQ(count_of(scene, "torus"), 176u);
    EXPECT_EQ(count_of(scene, "dish"), 43u);
    EXPECT_EQ(count_of(scene, "box"), 10u);
    EXPECT_EQ(count_of(scene, "pyramid"), 6u);
    std::uint64_t all = 0;
    for (const std::uint64_t count : scene.kind_counts) {
        all += count;
    }
    EXPECT_EQ(all, 1646u);
    EXPECT_EQ(scene.parts.size(), 1628u);  // 18 cylinders have no radius
    EXPECT_EQ(scene.findings.count(Severity::loss), 0u);
    EXPECT_EQ(scene.title, "/HDA");
    EXPECT_EQ(path_of(scene, 3), "/HA-PIPE/HA-PIPE-20/PL-202001_HA/PL-202001_HA/B1");
}

// The parameters of a part's shape, whatever its type.
std::vector<double> parameters_of(const Scene& scene, const Part& part) {
    std::vector<double> parameters;
    visit_shape(scene.shapes, part.type, part.shape, [&](const auto& shape) {
        using Shape = std::decay_t<decltype(shape)>;
        static_assert(std::is_trivially_copyable_v<Shape> && sizeof(Shape) % sizeof(double) == 0);
        parameters.resize(sizeof(Shape) / sizeof(double));
        std::memcpy(parameters.data(), &shape, sizeof(Shape));
    });
    return parameters;
}

// Whether two parts differ by no more than the text form rounds away.
bool is_same(const Scene& a_scene, const Part& a, const Scene& b_scene, const Part& b) {
    if (a.type != b.type || a.kind != b.kind || a.node != b.node || a.layer != b.layer) {
        return false;
    }
    const double distance = glm::length(a.placement.position - b.placement.position);
    const double turned = std::abs(glm::dot(a.placement.rotation, b.placement.rotation));
    const std::vector<double> a_parameters = parameters_of(a_scene, a);
    const std::vector<double> b_parameters = parameters_of(b_scene, b);
    // Millimetres and radians have five decimals; axes, five decimals at a size of 0.001, turn by
    // up to 0.3 degrees.
    const double tolerance = a.type == ShapeType::torus || a.type == ShapeType::snout ? 1e-5 : 2e-8;
    for (std::size_t i = 0; i < a_parameters.size(); ++i) {
        if (!(std::abs(a_parameters[i] - b_parameters[i]) < tolerance)) {
            return false;
        }
    }
    return distance < 1e-5 && turned > std::cos(0.5 * 0.3 * 3.1416 / 180.0);
}

// The two forms write a group's primitives before or after its child groups: only the order within
// a group counts.
std::vector<Part> sorted_by_node(const Scene& scene) {
    std::vector<Part> parts = scene.parts;
    std::stable_sort(parts.begin(), parts.end(),
                     [](const Part& a, const Part& b) { return a.node < b.node; });
    return parts;
}

TEST(rvm_files, text_form_equals_binary_form_within_its_rounding) {
    const std::string binary_path = test_data("rvm/HA-PIPE.RVM");
    const std::string text_path = test_data("rvm/HA-PIPE.rev");
    SKIP_WITHOUT(binary_path);
    SKIP_WITHOUT(text_path);
    const Scene binary = load_real(binary_path);
    const Scene text = load_real(text_path);

    ASSERT_EQ(binary.nodes.size(), text.nodes.size());
    for (std::size_t i = 0; i < binary.nodes.size(); ++i) {
        ASSERT_EQ(binary.strings[binary.nodes[i].name], text.strings[text.nodes[i].name]);
        ASSERT_EQ(binary.nodes[i].parent, text.nodes[i].parent);
        ASSERT_LT(glm::length(binary.nodes[i].position - text.nodes[i].position),
                  4e-5);  // a step of a float at 300,000 mm
    }
    ASSERT_EQ(binary.parts.size(), text.parts.size());
    EXPECT_EQ(binary.kind_counts, text.kind_counts);
    const std::vector<Part> binary_parts = sorted_by_node(binary);
    const std::vector<Part> text_parts = sorted_by_node(text);
    int mismatches = 0;
    for (std::size_t i = 0; i < binary_parts.size(); ++i) {
        mismatches += is_same(binary, binary_parts[i], text, text_parts[i]) ? 0 : 1;
    }
    EXPECT_EQ(mismatches, 0);
}

TEST(rvm_files, supports_have_the_known_counts_and_their_attributes) {
    const std::string path = test_data("rvm/WD1-PSUP.RVM");
    SKIP_WITHOUT(path);
    const Scene scene = load_real(path);
    EXPECT_EQ(count_of(scene, "box"), 936u);
    EXPECT_EQ(count_of(scene, "cylinder"), 624u);
    EXPECT_EQ(count_of(scene, "pyramid"), 472u);
    EXPECT_EQ(count_of(scene, "facet_group"), 334u);
    EXPECT_EQ(count_of(scene, "rectangular_torus"), 262u);
    EXPECT_EQ(count_of(scene, "line"), 129u);
    EXPECT_EQ(scene.meshes.size(), 334u);
    EXPECT_EQ(scene.findings.count(Severity::loss), 0u);

    // Every group of the model has its element in the attribute file.
    std::size_t joined = 0;
    for (const Node& node : scene.nodes) {
        joined += node.attribute_count > 0 ? 1u : 0u;
    }
    EXPECT_EQ(scene.nodes.size(), 4084u);
    EXPECT_EQ(joined, 4084u);
    const Node& root = scene.nodes[0];
    std::string discipline;
    std::string reference;
    for (std::uint32_t i = 0; i < root.attribute_count; ++i) {
        const Attribute& attribute = scene.attributes[root.first_attribute + i];
        const std::string_view key = scene.strings[attribute.key];
        discipline = key == "Discipline" ? scene.strings[attribute.value] : discipline;
        reference = key == "RefNo" ? scene.strings[attribute.value] : reference;
    }
    EXPECT_EQ(discipline, "PSUP");
    EXPECT_EQ(reference, "=16821/2");
    // "Name" of an element is its path's last name, so a wrong join would show.
    std::size_t named = 0;
    for (const Node& node : scene.nodes) {
        for (std::uint32_t i = 0; i < node.attribute_count; ++i) {
            const Attribute& attribute = scene.attributes[node.first_attribute + i];
            if (scene.strings[attribute.key] == "Name") {
                ++named;
                ASSERT_EQ(scene.strings[attribute.value], scene.strings[node.name]);
            }
        }
    }
    EXPECT_GT(named, 100u);
}

// The boxes that the writer stores are exact for these kinds: an oracle for parameters and frames.
void expect_bounds_as_stored(const std::string& path, std::size_t expected_count) {
    const Scene scene = load_real(path);
    const Result<Source> source = Source::open(path);
    Scene other;
    RvmGroups groups(other);
    RvmTally tally;
    const Result<RvmIndex> index = index_rvm(source.value().bytes(), {other, groups, tally});
    ASSERT_TRUE(index.ok());
    std::size_t part = 0;
    std::size_t compared = 0;
    RvmPrimitive primitive;
    RvmFacets facets;
    for (const RvmRecord& record : index.value().records) {
        ASSERT_TRUE(
            read_rvm_record(source.value().bytes(), record, primitive, facets).fault.empty());
        if (primitive.kind == RvmKind::cylinder && primitive.values[0] == 0.0f) {
            continue;  // not drawn
        }
        ASSERT_LT(part, scene.parts.size());
        const Part& drawn = scene.parts[part++];
        const bool exact = primitive.kind != RvmKind::pyramid && primitive.kind != RvmKind::snout &&
                           primitive.kind != RvmKind::sphere;
        if (!exact) {
            continue;
        }
        const RvmPlacement placement = read_placement(primitive.matrix, MatrixForm::binary);
        const auto corner = [&](std::size_t first) {
            return 0.001 * glm::dvec3(primitive.box[first], primitive.box[first + 1],
                                      primitive.box[first + 2]);
        };
        const glm::dvec3 half = 0.5 * (corner(3) - corner(0));
        const glm::dmat3 axes = glm::mat3_cast(placement.placement.rotation);
        const glm::dvec3 centre =
            placement.placement.position + axes * (0.5 * (corner(0) + corner(3)));
        const glm::dvec3 reach =
            glm::abs(axes[0]) * half.x + glm::abs(axes[1]) * half.y + glm::abs(axes[2]) * half.z;
        const Box3 bounds = world_bounds(scene, drawn);
        // Facets are far from the origin in floats: two of their steps.
        const double tolerance = primitive.kind == RvmKind::facet_group ? 7e-5 : 2e-6;
        ASSERT_LT(glm::length(bounds.low - (centre - reach)), tolerance) << record.offset;
        ASSERT_LT(glm::length(bounds.high - (centre + reach)), tolerance) << record.offset;
        ++compared;
    }
    EXPECT_EQ(part, scene.parts.size());
    EXPECT_EQ(compared, expected_count);
}

TEST(rvm_files, bounds_are_the_stored_boxes_where_these_are_exact) {
    const std::string piping = test_data("rvm/HA-PIPE.RVM");
    const std::string supports = test_data("rvm/WD1-PSUP.RVM");
    SKIP_WITHOUT(piping);
    SKIP_WITHOUT(supports);
    expect_bounds_as_stored(piping, 1073 + 176 + 43 + 10);
    expect_bounds_as_stored(supports, 936 + 624 + 334 + 262 + 129);
}

TEST(rvm_files, attributes_can_be_left_out) {
    const std::string path = test_data("rvm/WD1-PSUP.RVM");
    SKIP_WITHOUT(path);
    ImportOptions options;
    options.find_attributes = false;
    EXPECT_TRUE(load_real(path, options).attributes.empty());
}

TEST(rvm_files, facets_wind_like_their_unit_normals) {
    const std::string path = test_data("rvm/WD1-PSUP.RVM");
    SKIP_WITHOUT(path);
    const Scene scene = load_real(path);
    std::size_t against = 0;
    std::size_t triangles = 0;
    for (const Mesh& mesh : scene.meshes) {
        ASSERT_EQ(mesh.positions.size(), mesh.normals.size());
        for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
            const std::uint32_t a = mesh.indices[i];
            const glm::vec3 edge = mesh.positions[mesh.indices[i + 1]] - mesh.positions[a];
            const glm::vec3 other = mesh.positions[mesh.indices[i + 2]] - mesh.positions[a];
            const glm::vec3 winding = glm::cross(edge, other);
            // Smooth normals may be tilted far: it is enough if one of three agrees.
            bool agrees = false;
            for (std::size_t corner = i; corner < i + 3; ++corner) {
                agrees = agrees || glm::dot(winding, mesh.normals[mesh.indices[corner]]) >= 0.0f;
            }
            against += agrees ? 0u : 1u;
            ++triangles;
        }
        for (const glm::vec3& normal : mesh.normals) {
            ASSERT_NEAR(glm::length(normal), 1.0f, 1e-5f);
        }
    }
    EXPECT_GT(triangles, 5000u);
    EXPECT_EQ(against, 0u);
}

}  // namespace
}  // namespace quartic
