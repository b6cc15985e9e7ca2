// A cylinder around the local z axis, |z| <= height / 2; end 0 is the lower one.
struct Cylinder {
    real radius;  // > 0
    real height;  // > 0
    real unused_0;
    real unused_1;
};

Bounds bounds(Cylinder cylinder) {
    Bounds box;
    box.high = vec3(cylinder.radius, cylinder.radius, real(0.5) * cylinder.height);
    box.low = -box.high;
    return box;
}

int face_count(Cylinder cylinder) {
    return 3;
}

int end_count(Cylinder cylinder) {
    return 2;
}

End end(Cylinder cylinder, int index) {
    return upright_end(index, cylinder.height, cylinder.radius, real(0));
}

vec3 point(Cylinder cylinder, int face, vec2 uv) {
    real half_height = real(0.5) * cylinder.height;
    if (face == 0) {
        return polar(cylinder.radius, real(2) * pi() * uv.x, mix(-half_height, half_height, uv.y));
    }
    return disc_point(end(cylinder, face - 1), uv);
}

vec3 farthest(Cylinder cylinder, vec3 n) {
    real half_height = real(0.5) * cylinder.height;
    return farthest_of_disc(n.z < real(0) ? -half_height : half_height, cylinder.radius, n);
}

bool suits_outline(Cylinder cylinder) {
    return false;
}

int hull_rings(Cylinder cylinder) {
    return 2;
}

vec3 hull_point(Cylinder cylinder, int ring, int corner, real margin) {
    real z = real(0.5) * cylinder.height + margin;
    return octagon_corner(cylinder.radius + margin, corner, ring == 0 ? -z : z);
}

Hit hit(Cylinder cylinder, Ray ray, int open_ends, int solver) {
    real overlap = joint_overlap(cylinder.radius, real(0));
    real half_height = real(0.5) * cylinder.height;
    real low = wall_reach(open_ends, 0, half_height, overlap);
    real high = wall_reach(open_ends, 1, half_height, overlap);
    vec3 o = ray.origin;
    vec3 d = ray.direction;

    Span span = in_cone(vec3(o.x, o.y, cylinder.radius), vec3(d.x, d.y, 0));
    span = below_plane(span, o.z + low, d.z, 1);
    span = below_plane(span, high - o.z, -d.z, 2);
    Crossing crossing = first_crossing(span, ray.first, open_ends);
    if (!crossing.found) {
        return miss();
    }
    vec3 p = at(ray, crossing.t);
    vec3 normal = vec3(p.x, p.y, 0);
    if (crossing.face > 0) {
        normal = vec3(0, 0, crossing.face == 1 ? -1 : 1);
    }
    return hit_at(ray, crossing.t, normal);
}
