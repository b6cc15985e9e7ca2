// Writes the lists of visible parts, in order: one thread for each chunk.
#include "shaders/layout.glsl"
#include "shaders/cull_buffers.glsl"

layout(local_size_x = 64) in;
layout(std430, binding = binding_visible) writeonly buffer Visible {
    uint visible[];
};
layout(std430, binding = binding_near) writeonly buffer Near {
    uint near_parts[];
};
layout(location = 0) uniform uint chunk_count;

void main() {
    uint chunk_index = gl_GlobalInvocationID.x;
    if (chunk_index >= chunk_count) {
        return;
    }
    ChunkBlock chunk = chunks[chunk_index];
    for (uint i = 0u; i < chunk.count; ++i) {
        uvec2 decision = decisions[chunk.first + i];
        if (decision.x == no_column) {
            continue;
        }
        BatchBlock batch = batches[decision.x / uint(commands_per_batch)];
        int kind = int(decision.x % uint(commands_per_batch));
        uint slot = table[chunk_index * columns() + decision.x];
        table[chunk_index * columns() + decision.x] = slot + 1u;
        uint index = index_in_batch(decision.y);
        // Boxes fill the batch's part of the list from its start, hulls from its end.
        if (kind == command_near) {
            near_parts[batch.first + slot] = index;
        } else if (kind == command_hull) {
            visible[batch.first + batch.count - 1u - slot] = index;
        } else {
            visible[batch.first + slot] = index;
        }
    }
}
