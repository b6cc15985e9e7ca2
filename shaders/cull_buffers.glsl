// What the three culling dispatches share.
layout(std430, binding = binding_chunks) readonly buffer Chunks {
    ChunkBlock chunks[];
};
layout(std430, binding = binding_batches) readonly buffer Batches {
    BatchBlock batches[];
};
layout(std430, binding = binding_commands) buffer Commands {
    Command commands[];
};
// For each part, in the order of the bounds: its column, and its locator.
layout(std430, binding = binding_decisions) buffer Decisions {
    uvec2 decisions[];
};
// A row for each chunk, a column for each command of each batch: first how many parts of the chunk
// it draws, then how many of the chunks before.
layout(std430, binding = binding_table) buffer Table {
    uint table[];
};

const uint no_column = 0xffffffffu;

uint columns() {
    return uint(batches.length()) * uint(commands_per_batch);
}

uint index_in_batch(uint locator) {
    return locator & ((1u << locator_shift) - 1u);
}
