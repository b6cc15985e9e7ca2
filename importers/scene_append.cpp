// Appends arrays and moves the indices that point into them.
#include "importers/scene_append.h"

#include <array>
#include <iterator>

namespace quartic {

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

}  // namespace quartic
