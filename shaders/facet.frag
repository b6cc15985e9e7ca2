// One pixel of a facet of a polyhedron, which is drawn as its own triangles. Defines: THIS_SHAPE,
// [TRANSPARENT].
#include "shaders/layout.glsl"
#include "shaders/kernel.glsl"
#include "shaders/camera.glsl"
#include "shaders/surface_out.glsl"

#define PART_INTERFACE in
#include "shaders/part_interface.glsl"

void main() {
    // Twelve triangles a part, two a facet: box_indices in render/proxies.cpp begins with -z, +z,
    // -y, ...
    int pair = gl_PrimitiveID % 12 / 2;
    int facet = 4 - pair / 2 * 2 + pair % 2;
    put_surface(part_and_bits.x, turn(part_rotation, facet_normal(part_shape, facet)));
}
