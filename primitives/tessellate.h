// Any shape as triangles: face by face from its point() alone, or from where its value() vanishes.
#pragma once

#include "primitives/shape.h"

#include <cstdint>
#include <vector>

namespace quartic {

struct Triangles {
    std::vector<glm::dvec3> positions;
    std::vector<glm::dvec3> normals;  // one for each position, unit, out of the solid
    std::vector<std::uint32_t> indices;
    double deviation = 0.0;  // reached, of implicit surfaces; may be more than was asked for
};

// Triangles in the shape's frame that depart from its surface by at most the sagitta (metres, > 0);
// at most 4,096 steps a face and direction. Faces whose bit 1 + i is set in open_ends (end i) are
// left out.
#define SHAPE(id, Type, name) \
    Triangles tessellate(const f64::Type& shape, double sagitta, int open_ends = 0);
#include "primitives/catalog.h"
#undef SHAPE

}  // namespace quartic
