// The structs and numbers of shaders/layout.glsl as C++.
#pragma once

#include <glm/glm.hpp>

namespace quartic::gpu {

using uint = unsigned int;
using dvec4 = glm::dvec4;

#include "shaders/layout.glsl"

}  // namespace quartic::gpu
