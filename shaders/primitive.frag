// Solves one pixel of one part. Defines: THIS_SHAPE, THIS_SOLVER, [THIS_FORM], [NEAR],
// [TRANSPARENT], [INSPECT].
#include "shaders/layout.glsl"
#include "shaders/kernel.glsl"
#include "shaders/camera.glsl"
#include "shaders/ray_setup.glsl"
#include "shaders/surface_out.glsl"
#ifdef INSPECT
#include "shaders/inspect.glsl"
#endif

#define PART_INTERFACE in
#include "shaders/part_interface.glsl"

#if !defined(NEAR)
// The proxy's front faces lie before the surface: what fails the depth test there fails it
// everywhere.
layout(depth_less) out float gl_FragDepth;
#endif

void main() {
    Ray ray = ray_of(setup, gl_FragCoord.xy);
    int open_ends = int(part_and_bits.y & open_ends_mask);
#ifdef THIS_FORM
    ArcEnds ends;
    ends.planes = part_planes;
    ends.form = THIS_FORM % 4;
    ends.nears_axis = THIS_FORM >= 4;
    ends.open = open_ends;
    Hit found = hit_prepared(part_shape, ends, ray, THIS_SOLVER);
#else
    Hit found = hit(part_shape, ray, open_ends, THIS_SOLVER);
#endif
#ifdef INSPECT
    record_ray(ray, found);
#endif
    if (!found.found) {
        discard;
    }
    float value = buffer_depth(setup.depth + found.t);
#if !defined(NEAR)
    // Rounding must not break the promise above.
    value = min(value, gl_FragCoord.z);
#endif
    gl_FragDepth = value;
    put_surface(part_and_bits.x, turn(part_rotation, found.normal));
}
