// Proxies of the parts of one batch: what is rasterised to start their rays. Defines: THIS_SHAPE,
// HULL_RINGS, [LARGE] or [NEAR], [FACETS], [THIS_FORM].
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

#ifndef FACETS
// Proxies are wider than their shapes by this: a twentieth of a pixel, the joints' overlap, and
// float's error.
float margin_of(float distance, Bounds box) {
    float size = length(box.high - box.low);
    return 0.05 * setup.pixel_size + min(joint_overlap_max, 0.01 * size) + 2e-6 * (size + distance);
}

PartView part_view_of(vec3 from_eye, vec3 forward, Bounds box) {
    PartView view;
    view.centre = 0.5 * (box.low + box.high);
    view.parallel = camera.orthographic != 0;
    vec3 seen = from_eye + view.centre;
    view.forward = view.parallel ? forward : normalize(seen);
    view.depth = dot(seen, view.forward);
    return view;
}

#endif

#if defined(NEAR)
const int this_command = command_near;
#elif defined(LARGE)
const int this_command = command_hull;
#else
const int this_command = command_small;
#endif

uint vertices_of_part() {
#if defined(LARGE)
    return HULL_RINGS == 1 ? uint(outline_corners) : 8u * uint(HULL_RINGS);
#elif defined(NEAR) || defined(FACETS)
    return 8u;
#else
    return camera.proxy == proxy_box ? 8u : 4u;
#endif
}

#ifndef FACETS
// The vertex's corner of what is drawn of its part, in the shape's frame.
vec3 proxy_corner(THIS_SHAPE shape, PartView view, int vertex, float margin) {
#if defined(LARGE) && HULL_RINGS == 1
    return polygon_corner(shape, view, ivec2(vertex, outline_corners), margin);
#elif defined(LARGE)
    return hull_point(shape, min(vertex / 8, hull_rings(shape) - 1), vertex % 8, margin);
#else
#ifndef NEAR
    if (camera.proxy != proxy_box) {
        return polygon_corner(shape, view, ivec2(vertex, 4), margin);
    }
#endif
    Bounds box = bounds(shape);
    return mix(box.low - margin, box.high + margin,
               bvec3((vertex & 1) != 0, (vertex & 2) != 0, (vertex & 4) != 0));
#endif
}
#endif

void main() {
    BatchBlock batch = batches[batch_index];
    uint vertices = vertices_of_part();
    uint slot = uint(gl_InstanceID) * parts_per_instance + uint(gl_VertexID) / vertices;
    int vertex = int(uint(gl_VertexID) % vertices);
    if (slot >= commands[batch.first_command + uint(this_command)].part_count) {
        gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
        return;
    }
    // Small parts fill the batch's part of the list from its start, large ones from its end.
#if defined(NEAR)
    uint record_index = near_parts[batch.first + slot];
#elif defined(LARGE)
    uint record_index = visible[batch.first + batch.count - 1u - slot];
#else
    uint record_index = visible[batch.first + slot];
#endif

    Placement placement = records[record_index].placement;
    THIS_SHAPE shape = records[record_index].shape;
#if defined(THIS_FORM) && THIS_FORM % 4 >= 2
    shape.arc = 2.0 * pi();  // known, so that what ends need is not compiled
#endif
    dvec3 centre = place_from_eye(placement);
    dvec4 rotation = exact_rotation_of(placement);
#ifdef FACETS
    int facet_corner = corner_at((vertex & 1) != 0, (vertex & 2) != 0);
    vec3 corner = hull_point(shape, vertex / 4, facet_corner, 0.0);
#else
    Bounds box = bounds(shape);
    setup = make_ray_setup(centre, rotation, dvec3(box.low), dvec3(box.high));
    // What follows may err by a hundredth of a pixel: float suffices.
    vec3 in_shape = vec3(turn_back(rotation, centre));
    vec3 forward = turn_back(vec4(rotation), -vec3(camera.back.xyz));
    vec3 corner = proxy_corner(shape, part_view_of(in_shape, forward, box), vertex,
                               margin_of(length(in_shape), box));
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
