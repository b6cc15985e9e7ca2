// Reads a part's record: where it is relative to the eye and how it is turned.
layout(std430, binding = binding_chunks) readonly buffer Chunks {
    ChunkBlock chunks[];
};

dvec3 place_from_eye(Placement placement) {
    ChunkBlock chunk = chunks[placement.bits >> chunk_shift];
    return dvec3(chunk.x, chunk.y, chunk.z) - camera.eye.xyz +
           dvec3(placement.x, placement.y, placement.z);
}

int largest_of(Placement placement) {
    return int(placement.bits >> rotation_largest_shift) & 3;
}

dvec4 exact_rotation_of(Placement placement) {
    return rotation_of(double(placement.turn_a), double(placement.turn_b), double(placement.turn_c),
                       largest_of(placement));
}
