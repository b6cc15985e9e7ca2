// Uploads a packed scene.
#include "render/scene_buffers.h"

#include "scene/gpu_layout.h"

#include <algorithm>
#include <span>

namespace quartic {
namespace {

constexpr std::uint32_t page_bytes_max = 127u << 20;

template <class T>
GlBuffer upload_array(const std::vector<T>& array, SceneBuffers& scene, GLbitfield flags = 0) {
    scene.bytes += array.size() * sizeof(T);
    return make_buffer(std::as_bytes(std::span(array)), flags);
}

std::vector<gpu::ChunkBlock> chunk_blocks(const Packed& packed) {
    std::vector<gpu::ChunkBlock> blocks;
    blocks.reserve(packed.chunks.size());
    for (const Chunk& chunk : packed.chunks) {
        blocks.push_back(
            {chunk.origin.x, chunk.origin.y, chunk.origin.z, chunk.first, chunk.count});
    }
    return blocks;
}

std::vector<BoundsPage> bounds_pages(const Packed& packed) {
    constexpr std::uint32_t page_parts_max = page_bytes_max / sizeof(gpu::BoundsBlock);
    constexpr std::uint32_t page_chunks_max =
        65535;  // groups of one dispatch that every driver takes
    std::vector<BoundsPage> pages;
    for (std::uint32_t i = 0; i < packed.chunks.size(); ++i) {
        const Chunk& chunk = packed.chunks[i];
        if (pages.empty() || pages.back().chunk_count == page_chunks_max ||
            pages.back().bounds_count + chunk.count > page_parts_max) {
            // Storage blocks begin at multiples of 256 bytes: 8 bounds.
            const std::uint32_t first = chunk.first & ~7u;
            pages.push_back({i, 0, first, chunk.first - first});
        }
        pages.back().chunk_count += 1;
        pages.back().bounds_count += chunk.count;
    }
    return pages;
}

// The commands with small parts drawn by their boxes instead of quads.
std::vector<gpu::Command> with_boxes(std::vector<gpu::Command> commands,
                                     std::span<const gpu::BatchBlock> batches,
                                     const IndexRange& box) {
    for (const gpu::BatchBlock& batch : batches) {
        if (batch.drawn_as == gpu::drawn_as_rays || batch.drawn_as == gpu::drawn_as_outline) {
            gpu::Command& small = commands[batch.first_command + gpu::command_small];
            small.index_count = box.count;
            small.first_index = box.first;
        }
    }
    return commands;
}

gpu::Command proxy_command(const IndexRange& range) {
    gpu::Command command{};
    command.index_count = range.count;
    command.first_index = range.first;
    return command;
}

std::uint32_t drawn_as(const Batch& batch) {
    if (batch.type == ShapeType::mesh) {
        return gpu::drawn_as_mesh;
    }
    if (is_polyhedron(batch.type)) {
        return gpu::drawn_as_polyhedron;
    }
    return batch.hull_rings == outline_rings ? gpu::drawn_as_outline : gpu::drawn_as_rays;
}

void upload_batches(const Packed& packed, const Proxies& proxies, SceneBuffers& scene) {
    std::vector<gpu::BatchBlock> blocks;
    std::vector<gpu::Command> commands;
    std::uint32_t first = 0;
    std::size_t mesh = 0;
    for (const Batch& batch : packed.batches) {
        const auto first_command = static_cast<std::uint32_t>(commands.size());
        const bool is_mesh = batch.type == ShapeType::mesh;
        blocks.push_back({first, batch.count, first_command, drawn_as(batch)});
        first += batch.count;
        if (is_mesh) {
            for (std::uint32_t i = 0; i < batch.count; ++i) {
                const PackedMesh& placed = packed.meshes[mesh++];
                gpu::Command command{};
                command.index_count = placed.index_count;
                command.first_index = placed.first_index;
                command.base_vertex = placed.base_vertex;
                command.base_instance = i;
                commands.push_back(command);
            }
        } else {
            commands.push_back(
                proxy_command(is_polyhedron(batch.type) ? proxies.box : proxies.quad));
            commands.push_back(proxy_command(proxies.hulls.at(batch.hull_rings)));
            commands.push_back(proxy_command(proxies.box));
        }
        scene.bytes += batch.records.size();
        scene.draws.push_back({batch.type,
                               batch.transparent,
                               batch.count,
                               make_buffer(batch.records),
                               first_command,
                               {}});
    }
    scene.batches = upload_array(blocks, scene);
    scene.empty_commands = upload_array(commands, scene);
    scene.box_commands = upload_array(with_boxes(commands, blocks, proxies.box), scene);
    scene.commands = upload_array(commands, scene);
    scene.command_count = static_cast<std::uint32_t>(commands.size());
    scene.visible = make_empty_buffer(std::size_t{first} * 4);
    scene.near_parts = make_empty_buffer(std::size_t{first} * 4);
    scene.bytes += std::uint64_t{first} * 8;
}

void upload_meshes(const Packed& packed, SceneBuffers& scene) {
    scene.vertices = upload_array(packed.vertices, scene);
    scene.indices = upload_array(packed.indices, scene);
    scene.mesh_array = make_vertex_array();
    const GLuint array = scene.mesh_array.name();
    glVertexArrayVertexBuffer(array, 0, scene.vertices.name(), 0, sizeof(MeshVertex));
    glVertexArrayElementBuffer(array, scene.indices.name());
    const std::size_t offsets[] = {offsetof(MeshVertex, position), offsetof(MeshVertex, normal)};
    for (GLuint i = 0; i < 2; ++i) {
        glEnableVertexArrayAttrib(array, i);
        glVertexArrayAttribFormat(array, i, 3, GL_FLOAT, GL_FALSE, static_cast<GLuint>(offsets[i]));
        glVertexArrayAttribBinding(array, i, 0);
    }
}

}  // namespace

SceneBuffers upload(const Packed& packed, const Proxies& proxies) {
    SceneBuffers scene;
    scene.chunks = upload_array(chunk_blocks(packed), scene);
    scene.bounds = upload_array(packed.bounds, scene);
    scene.pages = bounds_pages(packed);
    scene.part_materials = upload_array(packed.part_materials, scene);
    scene.materials = upload_array(packed.materials, scene);
    scene.counts = make_empty_buffer(sizeof(gpu::CountsBlock));
    upload_batches(packed, proxies, scene);
    scene.chunk_count = static_cast<std::uint32_t>(packed.chunks.size());
    const std::size_t decision_bytes = packed.bounds.size() * 8;
    const std::size_t table_bytes = packed.chunks.size() * packed.batches.size() *
                                    static_cast<std::size_t>(gpu::commands_per_batch) * 4;
    scene.decisions = make_empty_buffer(decision_bytes);
    scene.table = make_empty_buffer(table_bytes);
    scene.bytes += decision_bytes + table_bytes;
    upload_meshes(packed, scene);
    scene.proxy_array = make_vertex_array();
    glVertexArrayElementBuffer(scene.proxy_array.name(), proxies.indices.name());
    return scene;
}

}  // namespace quartic
