// Puts together what was made apart: blocks of one scene's parts, or whole scenes.
#pragma once

#include "scene/scene.h"

#include <cstdint>
#include <span>

namespace quartic {

// Moves parts, shapes and meshes of the block to the end of the scene; its materials are renumbered
// by the table. The block's arrays end up empty but keep their memory, for the next block. Nodes,
// strings, findings and attributes are left alone.
void append_parts(Scene& scene, Scene& block, std::span<const std::uint32_t> material_numbers);

// Moves all of another scene to the end of this one: several files of one site become one model.
// Kinds of the same name are one kind; nodes, materials and strings are renumbered. Joints are not
// looked for.
void append_scene(Scene& scene, Scene&& other);

}  // namespace quartic
