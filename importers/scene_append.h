// Puts the parts that were made apart, in order, into one scene.
#pragma once

#include "scene/scene.h"

#include <cstdint>
#include <span>

namespace quartic {

// Moves parts, shapes and meshes of the block to the end of the scene; its materials are renumbered
// by the table. The block's arrays end up empty but keep their memory, for the next block. Nodes,
// strings, findings and attributes are left alone.
void append_parts(Scene& scene, Scene& block, std::span<const std::uint32_t> material_numbers);

}  // namespace quartic
