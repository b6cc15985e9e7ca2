// One pixel of a facet of a polyhedron, which is drawn as its own triangles. Defines: THIS_SHAPE,
// [TRANSPARENT].
#include "shaders/layout.glsl"
#include "shaders/kernel.glsl"
#include "shaders/camera.glsl"
#include "shaders/surface_out.glsl"

struct Record {
    Placement placement;
    THIS_SHAPE shape;
};
layout(std430, binding = binding_records) readonly buffer Records {
    Record records[];
};

flat in uint record_index;

void main() {
    Placement placement = records[record_index].placement;
    vec4 rotation = rotation_of(placement.turn_a, placement.turn_b, placement.turn_c,
                                int(placement.bits >> rotation_largest_shift) & 3);
    // Twelve triangles a part, two a facet: box_indices in render/proxies.cpp begins with -z, +z,
    // -y, ...
    int pair = gl_PrimitiveID % 12 / 2;
    int facet = 4 - pair / 2 * 2 + pair % 2;
    put_surface(placement.part, turn(rotation, facet_normal(records[record_index].shape, facet)));
}
