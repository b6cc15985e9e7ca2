// Which parts are in the picture, and by which proxy: one group for each chunk.
//
// Three dispatches make lists in the order of the chunks, whatever order the GPU works in, so that
// surfaces of equal depth look the same in every run: this one decides and counts,
// cull_offsets.comp adds up the chunks' counts, cull_lists.comp writes.
#include "shaders/layout.glsl"
#include "solvers/prelude.glsl"
#include "shaders/camera.glsl"
#include "shaders/cull_buffers.glsl"

layout(local_size_x = 64) in;
layout(std430, binding = binding_bounds) readonly buffer BoundsBuffer {
    BoundsBlock bounds[];
};
layout(std430, binding = binding_counts) buffer Counts {
    CountsBlock counts;
};

// The bounds are bound in pages: what this dispatch begins with.
layout(location = 0) uniform uint first_chunk;
layout(location = 1) uniform uint first_bounds;

// Parts that appear larger than this are rasterised by their hulls, which cost more vertices and
// fewer pixels.
const float hull_size_min_px = 240.0;

// A box relative to the eye: depth of its centre and half extent along the view.
struct Seen {
    bool inside;
    float nearest_depth;
    float size_px;
    float polygon_depth;  // the least that a corner of a polygon before the part can have
};

bool beyond(vec3 outward, float limit, vec3 centre, vec3 half_size) {
    return dot(outward, centre) - dot(abs(outward), half_size) > limit;
}

Seen look_at(vec3 centre, vec3 half_size) {
    vec3 right = vec3(camera.right.xyz);
    vec3 up = vec3(camera.up.xyz);
    vec3 back = vec3(camera.back.xyz);
    float near_depth = float(camera.near_depth);
    float depth = -dot(back, centre);
    float reach = dot(abs(back), half_size);
    vec2 half_picture = vec2(camera.half_width, camera.half_height) * float(camera.step);
    // Half a pixel for the jitter, and what float loses in these sums.
    float slack = 1e-5 * (length(centre) + length(half_size));
    float largest = 2.0 * max(half_size.x, max(half_size.y, half_size.z));

    Seen seen;
    seen.nearest_depth = depth - reach - slack;
    // The polygon lies across the line to the part's centre, as far before it as its radius; in a
    // picture of up to 100 degrees it leans to the eye by no more than as much again.
    seen.polygon_depth = depth - 2.2 * length(half_size) - slack;
    seen.inside = depth + reach + slack >= near_depth;
    if (camera.orthographic != 0) {
        vec2 limit = half_picture + float(camera.step) + slack;
        seen.size_px = largest / float(camera.step);
        seen.inside = seen.inside && !beyond(right, limit.x, centre, half_size) &&
                      !beyond(-right, limit.x, centre, half_size) &&
                      !beyond(up, limit.y, centre, half_size) &&
                      !beyond(-up, limit.y, centre, half_size);
    } else {
        vec2 limit = half_picture + float(camera.step);
        seen.size_px = largest / (float(camera.step) * max(depth - reach, near_depth));
        seen.inside = seen.inside && !beyond(right + limit.x * back, slack, centre, half_size) &&
                      !beyond(-right + limit.x * back, slack, centre, half_size) &&
                      !beyond(up + limit.y * back, slack, centre, half_size) &&
                      !beyond(-up + limit.y * back, slack, centre, half_size);
    }
    seen.inside = seen.inside || camera.cull_frustum == 0u;
    return seen;
}

// By its size, unless one kind of proxy is asked for. A polygon must not reach behind the near
// plane.
int ray_proxy(BatchBlock batch, Seen seen) {
    if (camera.proxy == proxy_box) {
        return command_small;
    }
    bool large = camera.proxy == proxy_automatic && seen.size_px > hull_size_min_px;
    bool close = camera.orthographic == 0 && seen.polygon_depth <= camera.near_from_eye;
    bool hull = large || close || camera.proxy == proxy_hull;
    return hull ? (close && batch.drawn_as == drawn_as_outline ? command_near : command_hull)
                : command_small;
}

// The proxy that the part is drawn by, as a column of the table of counts; no_column for meshes,
// whose draws are switched on right here.
uint column_of(uint locator, Seen seen) {
    BatchBlock batch = batches[locator >> locator_shift];
    if (batch.drawn_as == drawn_as_mesh) {
        commands[batch.first_command + index_in_batch(locator)].instance_count = 1u;
        return no_column;
    }
    int kind = command_small;
    // Facets have linear depths, as perspective needs them.
    bool facets = batch.drawn_as == drawn_as_polyhedron;
    float near_depth = float(camera.near_depth) + 0.001 * abs(float(camera.near_depth));
    if (seen.nearest_depth <= near_depth || (facets && camera.orthographic != 0)) {
        kind = command_near;
    } else if (!facets) {
        kind = ray_proxy(batch, seen);
    }
    return (locator >> locator_shift) * uint(commands_per_batch) + uint(kind);
}

void main() {
    uint chunk_index = first_chunk + gl_WorkGroupID.x;
    ChunkBlock chunk = chunks[chunk_index];
    vec3 from_eye = vec3(dvec3(chunk.x, chunk.y, chunk.z) - camera.eye.xyz);
    for (uint i = gl_LocalInvocationID.x; i < chunk.count; i += gl_WorkGroupSize.x) {
        BoundsBlock box = bounds[chunk.first + i - first_bounds];
        uint column = no_column;
        vec3 half_size = vec3(box.half_x, box.half_y, box.half_z);
        Seen seen = look_at(from_eye + vec3(box.centre_x, box.centre_y, box.centre_z), half_size);
        if ((camera.layer_mask >> box.layer & 1u) == 0u) {
            // Hidden: neither drawn nor culled.
        } else if (!seen.inside) {
            atomicAdd(counts.culled_by_frustum, 1u);
        } else if (seen.size_px < camera.size_min_px) {
            atomicAdd(counts.culled_by_size, 1u);
        } else {
            atomicAdd(counts.drawn, 1u);
            column = column_of(box.locator, seen);
        }
        decisions[chunk.first + i] = uvec2(column, box.locator);
        if (column != no_column) {
            atomicAdd(table[chunk_index * columns() + column], 1u);
        }
    }
}
