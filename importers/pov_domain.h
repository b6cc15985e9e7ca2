// The boxes to which POV-Ray's limits cut an algebraic surface, and the cubes that make up a box.
#pragma once

#include "importers/pov_object.h"

#include <span>
#include <string_view>
#include <vector>

namespace quartic {

// A box whose axes are the columns of a rotation, in metres, z up.
struct PovDomain {
    glm::dmat3 axes{1.0};
    Box3 box;                 // in the coordinates of the axes
    std::string_view remark;  // a constant text, if the box is not exactly what the file says
};

// POV-Ray's x right, y up, z into the picture (left-handed) as our x, z up, y away.
glm::dmat4 pov_to_world();

// The box that limits leave (their matrices lead into POV-Ray's world). Not finite on a side that
// none of them bounds. The axes are those of the first box, else those that are given.
PovDomain domain_of(std::span<const PovPlaced> limits, const glm::dmat3& axes);

// The columns made orthogonal and right-handed.
glm::dmat3 orthonormal(const glm::dmat3& matrix);

// A box around the real points of a surface, in its own coordinates; the default box if they go on
// without end.
struct PovExtent {
    Box3 box{glm::dvec3(-default_half_size), glm::dvec3(default_half_size)};
    bool closed = false;
    static constexpr double default_half_size = 5.0;
};
PovExtent extent_of(const Polynomial3& polynomial);

// Cubes whose union is the box, if few suffice; else the one around it.
struct PovCubes {
    std::vector<glm::dvec3> centres;
    double half_size = 0.0;
    bool exact = true;
};
PovCubes cubes_of(const Box3& box);
PovCubes cube_around(const Box3& box);

}  // namespace quartic
