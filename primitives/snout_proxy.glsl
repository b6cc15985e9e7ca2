// What is rasterised around a snout: its box, or a frustum of eight sides that leans with it.
vec3 farthest(Snout snout, vec3 n) {
    return farthest_of_box(bounds(snout), n);
}

bool suits_outline(Snout snout) {
    return false;
}

int hull_rings(Snout snout) {
    return 2;
}

vec3 hull_point(Snout snout, int ring, int corner, real margin) {
    Bounds box = bounds(snout);
    real z = ring == 0 ? box.low.z - margin : box.high.z + margin;
    real steepness = abs(radius_slope(snout)) + abs(snout.offset) / snout.height;
    real radius = max(real(0), radius_at(snout, z)) + margin * (real(1) + steepness);
    vec3 p = octagon_corner(radius, corner, z);
    p.x = p.x + snout.offset * z / snout.height;
    return p;
}
