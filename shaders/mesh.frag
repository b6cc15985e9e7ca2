// One pixel of a mesh part. Defines: [TRANSPARENT].
#include "shaders/layout.glsl"
#include "solvers/prelude.glsl"
#include "shaders/camera.glsl"
#include "shaders/surface_out.glsl"

flat in uint part;
in vec3 normal;
in float depth;

void main() {
    bool parallel = camera.orthographic != 0;
    if (parallel && depth < camera.near_from_focus) {
        discard;
    }
    gl_FragDepth = parallel ? buffer_depth(depth) : gl_FragCoord.z;
    put_surface(part, normalize(normal));
}
