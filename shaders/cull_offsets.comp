// Turns the counts of chunks into offsets, and fills in the indirect draws: one thread for each
// column.
#include "shaders/layout.glsl"
#include "shaders/cull_buffers.glsl"

layout(local_size_x = 64) in;
layout(location = 0) uniform uint chunk_count;

void main() {
    uint column = gl_GlobalInvocationID.x;
    uint batch_index = column / uint(commands_per_batch);
    if (column >= columns() || batches[batch_index].drawn_as == drawn_as_mesh) {
        return;
    }
    uint before = 0u;
    for (uint i = 0u; i < chunk_count; ++i) {
        uint here = table[i * columns() + column];
        table[i * columns() + column] = before;
        before += here;
    }
    uint command = batches[batch_index].first_command + column % uint(commands_per_batch);
    commands[command].part_count = before;
    commands[command].instance_count = (before + parts_per_instance - 1u) / parts_per_instance;
}
