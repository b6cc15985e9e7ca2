// Numbers as a picture's targets hold them, one text for C++ and GLSL: depths and normals.

// Depth behind the focus, in picture heights, as orthographic views keep it: before the focus
// linear, behind it as in perspective, so that float keeps its digits where one looks. Convex.
real focused(real heights) {
    return heights < real(0) ? real(1) - heights : real(1) / (real(1) + heights);
}

// The inverse of focused().
real unfocused(real value) {
    return value > real(1) ? real(1) - value : real(1) / value - real(1);
}

// A unit normal from its octahedral map, both coordinates in [-1, 1].
vec3 normal_from_octahedron(vec2 folded) {
    real z = real(1) - abs(folded.x) - abs(folded.y);
    real x = z >= real(0) ? folded.x
                          : (real(1) - abs(folded.y)) * (folded.x >= real(0) ? real(1) : real(-1));
    real y = z >= real(0) ? folded.y
                          : (real(1) - abs(folded.x)) * (folded.y >= real(0) ? real(1) : real(-1));
    return normalize(vec3(x, y, z));
}
