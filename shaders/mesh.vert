// Triangles of mesh parts; each part is its own indirect draw.
#extension GL_ARB_shader_draw_parameters : require
#include "shaders/layout.glsl"
#include "shaders/double_placement.glsl"
#include "solvers/prelude.glsl"
#include "primitives/placement.glsl"
#include "shaders/camera.glsl"
#include "shaders/records.glsl"

layout(std430, binding = binding_records) readonly buffer Records {
    Placement records[];
};
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 vertex_normal;

flat out uint part;
out vec3 normal;
out float depth;

void main() {
    Placement placement = records[gl_BaseInstanceARB];
    dvec4 rotation = exact_rotation_of(placement);
    part = placement.part;
    normal = turn(vec4(rotation), vertex_normal);
    dvec3 from_eye = place_from_eye(placement) + turn(rotation, dvec3(position));
    depth = float(-dot(camera.back.xyz, from_eye) - camera.focus_depth);
    gl_Position = clip_from_eye(from_eye);
}
