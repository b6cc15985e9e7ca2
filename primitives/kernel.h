// The primitives as C++, over any real type; the same texts are the GPU's.
#pragma once

#include "solvers/solver.h"

namespace quartic {

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored \
    "-Wunused-parameter"  // the contract's parameters, where a shape has no use for one

template <class Real>
struct Kernel {
#include "solvers/prelude.h"

#include "solvers/all.glsl"

#include "primitives/placement.glsl"
#include "primitives/ray.glsl"
#include "primitives/span.glsl"

#include "primitives/catalog.h"
};

#pragma GCC diagnostic pop

using f32 = Kernel<float>;
using f64 = Kernel<double>;

}  // namespace quartic
