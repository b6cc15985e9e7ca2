// Unit normals in 32 bits: the octahedral map, 16 bits an axis (error at most 0.003 degrees).
vec2 signs(vec2 v) {
    return vec2(v.x >= 0.0 ? 1.0 : -1.0, v.y >= 0.0 ? 1.0 : -1.0);
}

uint packed_normal(vec3 n) {
    vec2 flat_n = n.xy / (abs(n.x) + abs(n.y) + abs(n.z));
    vec2 folded = n.z >= 0.0 ? flat_n : (1.0 - abs(flat_n.yx)) * signs(flat_n);
    ivec2 whole = ivec2(floor(folded * 32767.0 + 0.5));  // |folded| <= 1: no clamp is needed
    return uint(whole.x & 0xffff) | uint(whole.y) << 16;
}

vec3 normal_from(uint bits) {
    return normal_from_octahedron(unpackSnorm2x16(bits));
}
