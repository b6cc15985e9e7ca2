// The texts that shaders share with C++ besides the shapes: buffers, and the numbers in pictures.
#pragma once

#include "solvers/solver.h"

#include <glm/glm.hpp>

namespace quartic::gpu {

using uint = unsigned int;
using dvec4 = glm::dvec4;

#include "shaders/layout.glsl"

template <class Real>
struct Picture {
#include "solvers/prelude.h"

#include "shaders/picture.glsl"
};

}  // namespace quartic::gpu
