// Replaces shapes by meshes; parts that share a shape go on sharing its mesh.
#include "cli/tessellated.h"

#include "primitives/tessellate.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

namespace quartic::cli {
namespace {

Mesh mesh_of(const Triangles& triangles) {
    Mesh mesh;
    mesh.positions.assign(triangles.positions.begin(), triangles.positions.end());
    mesh.normals.assign(triangles.normals.begin(), triangles.normals.end());
    mesh.indices = triangles.indices;
    return mesh;
}

}  // namespace

Scene tessellated(const Scene& scene, double sagitta) {
    using Key = std::tuple<ShapeType, std::uint32_t, int>;  // type, index, open ends
    std::map<Key, std::uint32_t> mesh_of_shape;
    Scene result = scene;
    result.shapes = {};
    for (Part& part : result.parts) {
        if (part.type == ShapeType::mesh) {
            continue;
        }
        const Key key{part.type, part.shape, part.open_ends};
        const auto next = static_cast<std::uint32_t>(result.meshes.size());
        const auto [entry, added] = mesh_of_shape.emplace(key, next);
        if (added) {
            visit_shape(scene.shapes, part.type, part.shape, [&](const auto& shape) {
                const Triangles triangles = tessellate(shape, sagitta, part.open_ends);
                result.max_deviation_m = std::max(result.max_deviation_m, triangles.deviation);
                result.meshes.push_back(mesh_of(triangles));
            });
        }
        part.type = ShapeType::mesh;
        part.shape = entry->second;
    }
    return result;
}

}  // namespace quartic::cli
