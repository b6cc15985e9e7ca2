// The shared solvers and primitives on floats.
#include "solvers/prelude.glsl"
#include "solvers/all.glsl"
#include "primitives/placement.glsl"
#include "primitives/ray.glsl"
#include "primitives/span.glsl"
#include "primitives/catalog.h"
