// A packed scene in GPU buffers, with one set of indirect draws for each batch.
#pragma once

#include "render/gl_objects.h"
#include "render/proxies.h"
#include "scene/pack.h"

#include <array>
#include <map>
#include <tuple>
#include <vector>

namespace quartic {

// One batch on the GPU.
struct DrawBatch {
    ShapeType type = ShapeType::mesh;
    bool transparent = false;
    std::uint32_t count = 0;
    GlBuffer records;
    std::uint32_t first_command = 0;
    std::array<GLuint, 3> programs{};  // by pass; 0 where there is none; SceneBuffers owns them
};

// Chunks whose bounds fit into one storage block.
struct BoundsPage {
    std::uint32_t first_chunk = 0;
    std::uint32_t chunk_count = 0;
    std::uint32_t first_bounds = 0;
    std::uint32_t bounds_count = 0;
};

// (type, solver, form, hull rings, transparent, pass, inspect)
using ProgramKey = std::tuple<int, int, int, int, bool, int, bool>;

struct SceneBuffers {
    GlBuffer chunks;
    GlBuffer bounds;
    GlBuffer batches;
    GlBuffer visible;
    GlBuffer near_parts;
    GlBuffer commands;
    GlBuffer empty_commands;  // copied over the commands at the start of each frame
    GlBuffer box_commands;    // the same, with small parts drawn by their boxes
    GlBuffer counts;
    GlBuffer decisions;
    GlBuffer table;
    GlBuffer part_materials;
    GlBuffer materials;
    GlBuffer vertices;
    GlBuffer indices;
    GlVertexArray mesh_array;
    GlVertexArray proxy_array;
    std::vector<DrawBatch> draws;
    bool has_translucent = false;  // any of them
    std::vector<BoundsPage> pages;
    std::uint32_t command_count = 0;
    std::uint32_t chunk_count = 0;
    std::uint64_t bytes = 0;
    std::map<ProgramKey, GlProgram> programs;
};

SceneBuffers upload(const Packed& packed, const Proxies& proxies);

}  // namespace quartic
