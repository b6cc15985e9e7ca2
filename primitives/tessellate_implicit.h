// Triangles of a surface that is given by where a function vanishes, within a cube.
#pragma once

#include "primitives/tessellate.h"

#include <functional>
#include <span>

namespace quartic {

struct ImplicitSurface {
    std::function<double(const glm::dvec3&)> value;
    std::function<glm::dvec3(const glm::dvec3&)> gradient;  // towards greater values
    double half_size = 1.0;                                 // of the cube around the origin
    // The values at from + i / (size - 1) * along; may be left out where value() is as fast.
    std::function<void(const glm::dvec3& from, const glm::dvec3& along, std::span<double> values)>
        row = {};
};

// Marches through tetrahedra on a grid that is made finer until the triangles depart by the sagitta
// at most, or the grid has implicit_steps_max steps along an edge, or a finer one hardly helped:
// Triangles::deviation says what was reached. Vertices lie on the surface; normals are those of the
// gradient. The mesh has no gap within the cube and is open at the cube's faces. Where sheets cross
// or meet in a point, triangles round off the crossing by about a step; what is thinner than a step
// may be missed.
Triangles tessellate_implicit(const ImplicitSurface& surface, double sagitta);

constexpr int implicit_steps_max = 128;

}  // namespace quartic
