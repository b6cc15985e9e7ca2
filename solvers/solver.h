// The solvers as C++, over any real type; the same texts are the GPU's.
#pragma once

#include <glm/glm.hpp>

namespace quartic {

// The scalar functions of GLSL that shared files use; those on vectors are found by lookup.
using glm::abs;
using glm::atan;
using glm::ceil;
using glm::clamp;
using glm::cos;
using glm::max;
using glm::min;
using glm::mix;
using glm::pow;
using glm::sin;
using glm::sqrt;
using glm::tan;

template <class Real>
struct Solver {
#include "solvers/prelude.h"

#include "solvers/all.glsl"
};

}  // namespace quartic
