// Proxies of the parts of one batch: what is rasterised to start their rays. Defines: THIS_SHAPE,
// HULL_RINGS, [NEAR], [FACETS].
#extension GL_ARB_shader_draw_parameters : require
#include "shaders/layout.glsl"
#include "shaders/double_placement.glsl"
#include "shaders/kernel.glsl"
#include "shaders/camera.glsl"
#include "shaders/records.glsl"
#include "shaders/ray_setup.glsl"
#include "shaders/make_ray_setup.glsl"

struct Record {
    Placement placement;
    THIS_SHAPE shape;
};
layout(std430, binding = binding_records) readonly buffer Records {
    Record records[];
};
layout(std430, binding = binding_visible) readonly buffer Visible {
    uint visible[];
};
layout(std430, binding = binding_near) readonly buffer Near {
    uint near_parts[];
};
layout(std430, binding = binding_commands) readonly buffer Commands {
    Command commands[];
};
layout(std430, binding = binding_batches) readonly buffer Batches {
    BatchBlock batches[];
};
layout(location = 0) uniform uint batch_index;

#ifndef FACETS
flat out RaySetup setup;
#endif
flat out uint record_index;

// Proxies are wider than their shapes by this: a twentieth of a pixel, the joints' overlap, and
// float's error.
double margin_of(dvec3 centre, Bounds box, double nearest_depth) {
    double size = double(length(box.high - box.low));
    double pixel =
        camera.step * (camera.orthographic != 0 ? 1.0 : max(nearest_depth, camera.near_depth));
    return 0.05 * pixel + min(double(joint_overlap_max), 0.01 * size) +
           2e-6 * (size + length(centre));
}

void main() {
    BatchBlock batch = batches[batch_index];
#ifdef NEAR
    int kind = command_near;
#else
    int kind = gl_DrawIDARB;
#endif
    uint vertices = kind == command_hull ? 8u * uint(HULL_RINGS) : 8u;
    uint slot = uint(gl_InstanceID) * parts_per_instance + uint(gl_VertexID) / vertices;
    int vertex = int(uint(gl_VertexID) % vertices);
    if (slot >= commands[batch.first_command + uint(kind)].part_count) {
        gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
        return;
    }
    // Boxes fill the batch's part of the list from its start, hulls from its end.
#ifdef NEAR
    record_index = near_parts[batch.first + slot];
#else
    record_index =
        visible[kind == command_hull ? batch.first + batch.count - 1u - slot : batch.first + slot];
#endif

    Placement placement = records[record_index].placement;
    THIS_SHAPE shape = records[record_index].shape;
    dvec3 centre = place_from_eye(placement);
    dvec4 rotation = exact_rotation_of(placement);
#ifdef FACETS
    int facet_corner = corner_at((vertex & 1) != 0, (vertex & 2) != 0);
    vec3 corner = hull_point(shape, vertex / 4, facet_corner, 0.0);
#else
    Bounds box = bounds(shape);
    setup = make_ray_setup(centre, rotation, dvec3(box.low), dvec3(box.high));

    float margin = float(margin_of(centre, box, double(setup.depth)));
    vec3 corner;
    if (kind == command_hull) {
        corner = hull_point(shape, min(vertex / 8, hull_rings(shape) - 1), vertex % 8, margin);
    } else {
        corner = mix(box.low - margin, box.high + margin,
                     bvec3((vertex & 1) != 0, (vertex & 2) != 0, (vertex & 4) != 0));
    }
#endif
    dvec3 from_eye = centre + turn(rotation, dvec3(corner));
    gl_Position = clip_from_eye(from_eye);
#ifndef NEAR
    if (camera.orthographic != 0) {
        // Convex: between the vertices it is interpolated to no less than what fragments write.
        gl_Position.z = buffer_depth(float(-dot(camera.back.xyz, from_eye) - camera.focus_depth));
    }
#endif
}
