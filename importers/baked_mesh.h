// Shapes that a file stretches, shears or mirrors: no shape of ours is such a thing, so they become
// triangles.
#pragma once

#include "primitives/tessellate.h"
#include "scene/scene.h"

namespace quartic {

// The triangles of a part that is a shape, where its placement puts them.
Triangles triangles_of_part(const Scene& scene, const Part& part, double sagitta);

// The vector made unit, or the other one where it is none.
glm::vec3 unit_or(const glm::dvec3& vector, const glm::dvec3& otherwise);

// Moves triangles through a matrix, around a centre of their own that is left out of the mesh; a
// mirror turns their winding.
Mesh baked_mesh(const Triangles& triangles, const glm::dmat3& axes, glm::dvec3& centre);

}  // namespace quartic
