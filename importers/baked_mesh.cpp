// Triangles through a general matrix.
#include "importers/baked_mesh.h"

#include <cmath>
#include <utility>

namespace quartic {
glm::vec3 unit_or(const glm::dvec3& vector, const glm::dvec3& otherwise) {
    const double square = glm::dot(vector, vector);
    const bool sound = std::isfinite(square) && square > 1e-30;
    return glm::vec3(sound ? vector / std::sqrt(square) : otherwise);
}

Triangles triangles_of_part(const Scene& scene, const Part& part, double sagitta) {
    Triangles triangles = visit_shape(scene.shapes, part.type, part.shape, [&](const auto& shape) {
        return tessellate(shape, sagitta);
    });
    const glm::dmat3 rotation = glm::mat3_cast(part.placement.rotation);
    for (glm::dvec3& position : triangles.positions) {
        position = part.placement.position + rotation * position;
    }
    for (glm::dvec3& normal : triangles.normals) {
        normal = rotation * normal;
    }
    return triangles;
}

Mesh baked_mesh(const Triangles& triangles, const glm::dmat3& axes, glm::dvec3& centre) {
    Box3 box;
    for (const glm::dvec3& position : triangles.positions) {
        const glm::dvec3 moved = axes * position;
        box.low = glm::min(box.low, moved);
        box.high = glm::max(box.high, moved);
    }
    centre = 0.5 * (box.low + box.high);
    const glm::dmat3 normal_axes = glm::transpose(glm::inverse(axes));
    Mesh mesh;
    mesh.positions.reserve(triangles.positions.size());
    mesh.normals.reserve(triangles.normals.size());
    for (std::size_t i = 0; i < triangles.positions.size(); ++i) {
        mesh.positions.emplace_back(axes * triangles.positions[i] - centre);
        mesh.normals.push_back(unit_or(normal_axes * triangles.normals[i], {0.0, 0.0, 1.0}));
    }
    mesh.indices = triangles.indices;
    if (glm::determinant(axes) < 0.0) {
        for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
            std::swap(mesh.indices[i + 1], mesh.indices[i + 2]);
        }
    }
    return mesh;
}

}  // namespace quartic
