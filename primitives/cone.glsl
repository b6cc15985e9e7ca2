// A frustum of a right circular cone around the local z axis, |z| <= height / 2; end 0 is the lower
// one.
struct Cone {
    real bottom_radius;  // >= 0; at least one radius > 0
    real top_radius;     // >= 0
    real height;         // > 0
    real unused_0;
};

real radius_slope(Cone cone) {
    return (cone.top_radius - cone.bottom_radius) / cone.height;
}

Bounds bounds(Cone cone) {
    real radius = max(cone.bottom_radius, cone.top_radius);
    Bounds box;
    box.high = vec3(radius, radius, real(0.5) * cone.height);
    box.low = -box.high;
    return box;
}

int face_count(Cone cone) {
    return 3;
}

int end_count(Cone cone) {
    return 2;
}

End end(Cone cone, int index) {
    return upright_end(index, cone.height, index == 0 ? cone.bottom_radius : cone.top_radius,
                       radius_slope(cone));
}

vec3 point(Cone cone, int face, vec2 uv) {
    real half_height = real(0.5) * cone.height;
    if (face == 0) {
        return polar(mix(cone.bottom_radius, cone.top_radius, uv.y), real(2) * pi() * uv.x,
                     mix(-half_height, half_height, uv.y));
    }
    return disc_point(end(cone, face - 1), uv);
}

vec3 farthest(Cone cone, vec3 n) {
    real half_height = real(0.5) * cone.height;
    return farther(farthest_of_disc(-half_height, cone.bottom_radius, n),
                   farthest_of_disc(half_height, cone.top_radius, n), n);
}

bool suits_outline(Cone cone) {
    return false;
}

int hull_rings(Cone cone) {
    return 2;
}

vec3 hull_point(Cone cone, int ring, int corner, real margin) {
    // Where the margin lengthens the frustum, the cone goes on widening.
    real steepness = abs(radius_slope(cone));
    real radius =
        (ring == 0 ? cone.bottom_radius : cone.top_radius) + margin * (real(1) + steepness);
    real z = real(0.5) * cone.height + margin;
    return octagon_corner(radius, corner, ring == 0 ? -z : z);
}

Hit hit(Cone cone, Ray ray, int open_ends, int solver) {
    real slope = radius_slope(cone);
    real overlap = joint_overlap(max(cone.bottom_radius, cone.top_radius), slope);
    real half_height = real(0.5) * cone.height;
    real low = wall_reach(open_ends, 0, half_height, overlap);
    real high = wall_reach(open_ends, 1, half_height, overlap);
    vec3 o = ray.origin;
    vec3 d = ray.direction;

    real radius_at_origin = real(0.5) * (cone.bottom_radius + cone.top_radius) + slope * o.z;
    Span span = in_cone(vec3(o.x, o.y, radius_at_origin), vec3(d.x, d.y, slope * d.z));
    span = below_plane(span, o.z + low, d.z, 1);
    span = below_plane(span, high - o.z, -d.z, 2);
    Crossing crossing = first_crossing(span, ray.first, open_ends);
    if (!crossing.found) {
        return miss();
    }
    vec3 p = at(ray, crossing.t);
    real rho = length(vec2(p));
    vec3 normal =
        rho > real(0) ? vec3(p.x, p.y, -slope * rho) : vec3(0, 0, slope < real(0) ? 1 : -1);
    if (crossing.face > 0) {
        normal = vec3(0, 0, crossing.face == 1 ? -1 : 1);
    }
    return hit_at(ray, crossing.t, normal);
}
