// Solves one pixel of one part. Defines: THIS_SHAPE, THIS_SOLVER, [NEAR], [TRANSPARENT],
// [INSPECT].
#include "shaders/layout.glsl"
#include "shaders/kernel.glsl"
#include "shaders/camera.glsl"
#include "shaders/ray_setup.glsl"
#include "shaders/surface_out.glsl"
#ifdef INSPECT
#include "shaders/inspect.glsl"
#endif

struct Record {
    Placement placement;
    THIS_SHAPE shape;
};
layout(std430, binding = binding_records) readonly buffer Records {
    Record records[];
};

flat in RaySetup setup;
flat in uint record_index;

#if !defined(NEAR)
// The proxy's front faces lie before the surface: what fails the depth test there fails it
// everywhere.
layout(depth_less) out float gl_FragDepth;
#endif

void main() {
    Placement placement = records[record_index].placement;
    Ray ray = ray_of(setup, gl_FragCoord.xy);
    Hit found = hit(records[record_index].shape, ray, int(placement.bits & open_ends_mask),
                    THIS_SOLVER);
#ifdef INSPECT
    record_ray(ray, found);
#endif
    if (!found.found) {
        discard;
    }
    vec4 rotation = rotation_of(placement.turn_a, placement.turn_b, placement.turn_c,
                                int(placement.bits >> rotation_largest_shift) & 3);
    float value = buffer_depth(setup.depth + found.t);
#if !defined(NEAR)
    // Rounding must not break the promise above.
    value = min(value, gl_FragCoord.z);
#endif
    gl_FragDepth = value;
    put_surface(placement.part, turn(rotation, found.normal));
}
