// Proxies of the parts of one batch: what is rasterised to start their rays. Defines: THIS_SHAPE,
// HULL_RINGS, [NEAR], [FACETS], [THIS_FORM].
#extension GL_ARB_shader_draw_parameters : require
#include "shaders/layout.glsl"
#include "shaders/double_placement.glsl"
#include "shaders/kernel.glsl"
#include "shaders/camera.glsl"
#include "shaders/records.glsl"
#include "shaders/ray_setup.glsl"
#include "shaders/make_ray_setup.glsl"
#include "shaders/screen_polygon.glsl"
#define PART_INTERFACE out
#include "shaders/part_interface.glsl"

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

// Proxies are wider than their shapes by this: a twentieth of a pixel, the joints' overlap, and
// float's error.
double margin_of(dvec3 centre, Bounds box, double nearest_depth) {
    double size = double(length(box.high - box.low));
    double pixel =
        camera.step * (camera.orthographic != 0 ? 1.0 : max(nearest_depth, camera.near_depth));
    return 0.05 * pixel + min(double(joint_overlap_max), 0.01 * size) +
           2e-6 * (size + length(centre));
}

PartView part_view_of(dvec3 centre, dvec4 rotation, Bounds box) {
    PartView view;
    view.centre = 0.5 * (box.low + box.high);
    view.parallel = camera.orthographic != 0;
    dvec3 seen = turn_back(rotation, centre) + dvec3(view.centre);
    dvec3 forward = view.parallel ? turn_back(rotation, -camera.back.xyz) : normalize(seen);
    view.forward = vec3(forward);
    view.depth = float(dot(seen, forward));
    return view;
}

uint vertices_of(int kind) {
#ifndef FACETS
    if (kind == command_hull) {
        return HULL_RINGS == 1 ? uint(outline_corners) : 8u * uint(HULL_RINGS);
    }
    if (kind == command_small && camera.proxy != proxy_box) {
        return 4u;
    }
#endif
    return 8u;
}

// The vertex's corner of what is drawn of its part, in the shape's frame.
vec3 proxy_corner(THIS_SHAPE shape, PartView view, int kind, int vertex, float margin) {
    if (kind == command_hull) {
#if HULL_RINGS == 1
        return polygon_corner(shape, view, ivec2(vertex, outline_corners), margin);
#else
        return hull_point(shape, min(vertex / 8, hull_rings(shape) - 1), vertex % 8, margin);
#endif
    }
    if (kind == command_small && camera.proxy != proxy_box) {
        return polygon_corner(shape, view, ivec2(vertex, 4), margin);
    }
    Bounds box = bounds(shape);
    return mix(box.low - margin, box.high + margin,
               bvec3((vertex & 1) != 0, (vertex & 2) != 0, (vertex & 4) != 0));
}

void main() {
    BatchBlock batch = batches[batch_index];
#ifdef NEAR
    int kind = command_near;
#else
    int kind = gl_DrawIDARB;
#endif
    uint vertices = vertices_of(kind);
    uint slot = uint(gl_InstanceID) * parts_per_instance + uint(gl_VertexID) / vertices;
    int vertex = int(uint(gl_VertexID) % vertices);
    if (slot >= commands[batch.first_command + uint(kind)].part_count) {
        gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
        return;
    }
    // Small parts fill the batch's part of the list from its start, hulls from its end.
#ifdef NEAR
    uint record_index = near_parts[batch.first + slot];
#else
    uint record_index =
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
    vec3 corner = proxy_corner(shape, part_view_of(centre, rotation, box), kind, vertex, margin);
#endif
    part_shape = shape;
    part_rotation =
        rotation_of(placement.turn_a, placement.turn_b, placement.turn_c, largest_of(placement));
    part_and_bits = uvec2(placement.part, placement.bits);
#ifdef THIS_FORM
    part_planes = prepare(shape, int(placement.bits & open_ends_mask)).planes;
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
