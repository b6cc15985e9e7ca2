// Queries on the document: boxes and paths.
#include "scene/scene.h"

#include "solvers/solver_table.h"

#include <algorithm>

namespace quartic {
namespace {

Box3 local_bounds(const Scene& scene, const Part& part) {
    Box3 box;
    if (part.type == ShapeType::mesh) {
        for (const glm::vec3& p : scene.meshes[part.shape].positions) {
            box.low = glm::min(box.low, glm::dvec3(p));
            box.high = glm::max(box.high, glm::dvec3(p));
        }
        return box;
    }
    visit_shape(scene.shapes, part.type, part.shape, [&](const auto& shape) {
        const f64::Bounds bounds = f64().bounds(shape);
        box.low = bounds.low;
        box.high = bounds.high;
    });
    return box;
}

}  // namespace

std::uint32_t add_mesh_part(Scene& scene, Mesh mesh, Part part) {
    part.type = ShapeType::mesh;
    part.shape = static_cast<std::uint32_t>(scene.meshes.size());
    scene.meshes.push_back(std::move(mesh));
    scene.parts.push_back(part);
    return static_cast<std::uint32_t>(scene.parts.size() - 1);
}

Box3 world_bounds(const Scene& scene, const Part& part) {
    const Box3 local = local_bounds(scene, part);
    if (local.empty()) {
        return local;
    }
    const glm::dmat3 axes = glm::mat3_cast(part.placement.rotation);
    const glm::dvec3 half = 0.5 * (local.high - local.low);
    const glm::dvec3 centre = part.placement.position + axes * (0.5 * (local.low + local.high));
    const glm::dvec3 reach =
        glm::abs(axes[0]) * half.x + glm::abs(axes[1]) * half.y + glm::abs(axes[2]) * half.z;
    return {centre - reach, centre + reach};
}

std::vector<Box3> part_boxes(const Scene& scene, const std::array<bool, layer_count>& layers) {
    std::vector<Box3> boxes;
    boxes.reserve(scene.parts.size());
    for (const Part& part : scene.parts) {
        const Box3 box =
            layers[static_cast<std::size_t>(part.layer)] ? world_bounds(scene, part) : Box3{};
        if (!box.empty()) {
            boxes.push_back(box);
        }
    }
    return boxes;
}

Box3 world_bounds(const Scene& scene, const std::array<bool, layer_count>& layers) {
    Box3 all;
    for (const Box3& box : part_boxes(scene, layers)) {
        all.low = glm::min(all.low, box.low);
        all.high = glm::max(all.high, box.high);
    }
    return all;
}

int solver_of(const Scene& scene, const Part& part, int everywhere,
              std::span<const int> of_materials) {
    int chosen = everywhere;
    if (chosen == 0 && part.material < of_materials.size()) {
        chosen = of_materials[part.material];
    } else if (chosen == 0 && part.material < scene.materials.size()) {
        chosen = scene.materials[part.material].solver;
    }
    return solver_for(name(part.type), chosen);
}

std::string path_of(const Scene& scene, std::uint32_t node) {
    std::vector<std::string_view> names;
    for (std::uint32_t at = node; at != no_index; at = scene.nodes[at].parent) {
        names.push_back(scene.strings[scene.nodes[at].name]);
    }
    std::string path;
    for (auto name = names.rbegin(); name != names.rend(); ++name) {
        path += name->starts_with('/') ? "" : "/";
        path += *name;
    }
    return path;
}

}  // namespace quartic
