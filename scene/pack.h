// The document as the GPU wants it: float records relative to chunk origins, batched by shape and
// solver.
#pragma once

#include "scene/scene.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace quartic {

// Parts that lie close together, at most chunk_parts_max, with the double origin of their float
// positions.
struct Chunk {
    glm::dvec3 origin;
    std::uint32_t first = 0;  // in Packed::bounds
    std::uint32_t count = 0;
};
constexpr std::uint32_t chunk_parts_max = 1024;

// A part's world-axis box relative to its chunk's origin, and where its record is.
struct PackedBounds {
    glm::vec3 centre;
    std::uint32_t locator = 0;  // batch << 24 | index in the batch
    glm::vec3 half_size;
    std::uint32_t layer = 0;
};
static_assert(sizeof(PackedBounds) == 32);

// Stands for rings where large parts are drawn from polygons around their outlines in the picture.
constexpr int outline_rings = 1;

// Records of one shape, one solver and one kind of drawing. Each record is a gpu::Placement and the
// float shape.
struct Batch {
    ShapeType type = ShapeType::mesh;
    int solver = 0;
    bool transparent = false;
    int form = 0;        // of Prepared shapes: how programs count their ends (arc_forms)
    int hull_rings = 2;  // most rings that a hull of the batch needs, or outline_rings
    std::uint32_t count = 0;
    std::uint32_t record_bytes = 0;
    std::vector<std::byte> records;
};

// Triangles of all meshes; a mesh part's record says which of them are its.
struct PackedMesh {
    std::uint32_t first_index = 0;
    std::uint32_t index_count = 0;
    std::int32_t base_vertex = 0;
};
struct MeshVertex {
    glm::vec3 position;
    glm::vec3 normal;
};

struct Packed {
    std::vector<Chunk> chunks;
    std::vector<PackedBounds> bounds;
    std::vector<Batch> batches;
    std::vector<PackedMesh> meshes;  // one for each record of the mesh batches, batch after batch
    std::vector<MeshVertex> vertices;
    std::vector<std::uint32_t> indices;
    std::vector<std::uint32_t> part_materials;  // by part id
    std::vector<glm::vec4> materials;           // linear colours
    Box3 box;                                   // of all parts
};

struct PackOptions {
    bool transparent_as_opaque = false;  // for checks: everything has an id and a depth
    int solver = 0;                      // overrides the materials' solvers; 0: does not
    std::vector<int> material_solvers;   // stand for the materials' own, if not empty
};

Packed pack(const Scene& scene, const PackOptions& options = {});

}  // namespace quartic
