// One pixel of a mesh part. Defines: [TRANSPARENT].
#include "shaders/layout.glsl"
#include "shaders/camera.glsl"
#include "shaders/surface_out.glsl"

flat in uint part;
in vec3 normal;

void main() {
    put_surface(part, normalize(normal));
}
