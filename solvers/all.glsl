// Every solver, in the order in which they use each other.
#include "solvers/quadratic.glsl"
#include "solvers/quartic.glsl"
#include "solvers/convexity_split.glsl"
#include "solvers/newton.glsl"
#include "solvers/first_root.glsl"
