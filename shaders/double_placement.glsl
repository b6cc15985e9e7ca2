// The functions of primitives/placement.glsl on doubles: the same text with other types.
#define real double
#define vec3 dvec3
#define vec4 dvec4
#include "primitives/placement.glsl"
#undef real
#undef vec3
#undef vec4
