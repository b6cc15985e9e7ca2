// Appends arrays and moves the indices that point into them.
#include "scene/append.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <numeric>
#include <vector>

namespace quartic {
namespace {

// The number in the scene of each kind of the other scene.
std::vector<std::uint8_t> append_kinds(Scene& scene, const Scene& other) {
    std::vector<std::uint8_t> numbers;
    for (std::size_t i = 0; i < other.kinds.size(); ++i) {
        const auto known = std::find(scene.kinds.begin(), scene.kinds.end(), other.kinds[i]);
        const auto number = static_cast<std::size_t>(known - scene.kinds.begin());
        if (known == scene.kinds.end()) {
            scene.kinds.push_back(other.kinds[i]);
        }
        scene.kind_counts.resize(scene.kinds.size());
        scene.kind_counts[number] += i < other.kind_counts.size() ? other.kind_counts[i] : 0;
        numbers.push_back(static_cast<std::uint8_t>(number));
    }
    return numbers;
}

void append_nodes(Scene& scene, const Scene& other) {
    std::vector<StringPool::Id> names(other.strings.size());
    for (StringPool::Id id = 0; id < names.size(); ++id) {
        names[id] = scene.strings.add(other.strings[id]);
    }
    const auto first_node = static_cast<std::uint32_t>(scene.nodes.size());
    const auto first_attribute = static_cast<std::uint32_t>(scene.attributes.size());
    for (Node node : other.nodes) {
        node.name = names[node.name];
        node.parent = node.parent == no_index ? no_index : node.parent + first_node;
        node.first_attribute += first_attribute;
        scene.nodes.push_back(node);
    }
    for (const Attribute& attribute : other.attributes) {
        scene.attributes.push_back({names[attribute.key], names[attribute.value]});
    }
}

void append_outcomes(Scene& scene, const Scene& other) {
    for (const Outcome& outcome : other.outcomes) {
        const auto same =
            std::find_if(scene.outcomes.begin(), scene.outcomes.end(), [&](const Outcome& known) {
                return known.kind == outcome.kind && known.became == outcome.became &&
                       known.reason == outcome.reason;
            });
        if (same == scene.outcomes.end()) {
            scene.outcomes.push_back(outcome);
        } else {
            same->count += outcome.count;
        }
    }
}

}  // namespace

void append_parts(Scene& scene, Scene& block, std::span<const std::uint32_t> material_numbers) {
    std::array<std::uint32_t, 256> first_of{};  // by type
    first_of[static_cast<std::size_t>(ShapeType::mesh)] =
        static_cast<std::uint32_t>(scene.meshes.size());
    scene.meshes.insert(scene.meshes.end(), std::make_move_iterator(block.meshes.begin()),
                        std::make_move_iterator(block.meshes.end()));
    block.meshes.clear();
#define SHAPE(id, Type, name)                                                    \
    first_of[id] = static_cast<std::uint32_t>(scene.shapes.name.size());         \
    scene.shapes.name.insert(scene.shapes.name.end(), block.shapes.name.begin(), \
                             block.shapes.name.end());                           \
    block.shapes.name.clear();
#include "primitives/catalog.h"
#undef SHAPE
    for (Part& part : block.parts) {
        part.shape += first_of[static_cast<std::size_t>(part.type)];
        part.material = material_numbers[part.material];
    }
    scene.parts.insert(scene.parts.end(), block.parts.begin(), block.parts.end());
    block.parts.clear();
}

void append_scene(Scene& scene, Scene&& other) {
    const auto first_node = static_cast<std::uint32_t>(scene.nodes.size());
    const std::vector<std::uint8_t> kinds = append_kinds(scene, other);
    std::vector<std::uint32_t> materials(other.materials.size());
    std::iota(materials.begin(), materials.end(),
              static_cast<std::uint32_t>(scene.materials.size()));
    scene.materials.insert(scene.materials.end(), other.materials.begin(), other.materials.end());
    append_nodes(scene, other);
    for (Part& part : other.parts) {
        part.node += first_node;
        part.kind = kinds[part.kind];
    }
    append_parts(scene, other, materials);
    append_outcomes(scene, other);
    scene.max_deviation_m = std::max(scene.max_deviation_m, other.max_deviation_m);
    scene.findings.add_all(other.findings);
    scene.title += (scene.title.empty() || other.title.empty() ? "" : " + ") + other.title;
}

}  // namespace quartic
