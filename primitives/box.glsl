// A box centred on the local origin.
struct Box {
    real length_x;  // full lengths, >= 0; at most one is 0
    real length_y;
    real length_z;
    real unused_0;
};

Bounds bounds(Box box) {
    Bounds result;
    result.high = real(0.5) * vec3(box.length_x, box.length_y, box.length_z);
    result.low = -result.high;
    return result;
}

int face_count(Box box) {
    return 6;
}

int end_count(Box box) {
    return 0;
}

End end(Box box, int index) {
    return no_end();
}

// The outer normal of face 0-5: -x, +x, -y, +y, -z, +z.
vec3 box_normal(int face) {
    real side = face % 2 == 0 ? real(-1) : real(1);
    return face < 2 ? vec3(side, 0, 0) : (face < 4 ? vec3(0, side, 0) : vec3(0, 0, side));
}

vec3 point(Box box, int face, vec2 uv) {
    vec3 normal = box_normal(face);
    vec3 u_axis = face < 2 ? vec3(0, 1, 0) : (face < 4 ? vec3(0, 0, 1) : vec3(1, 0, 0));
    vec3 v_axis = cross(normal, u_axis);
    return bounds(box).high *
           (normal + (real(2) * uv.x - real(1)) * u_axis + (real(2) * uv.y - real(1)) * v_axis);
}

// The normal of a facet, as polyhedra have them: their hulls without margin are themselves, so they
// are rasterised.
vec3 facet_normal(Box box, int facet) {
    return box_normal(facet);
}

vec3 farthest(Box box, vec3 n) {
    return farthest_of_box(bounds(box), n);
}

bool suits_outline(Box box) {
    return false;
}

int hull_rings(Box box) {
    return 2;
}

vec3 hull_point(Box box, int ring, int corner, real margin) {
    vec3 high = bounds(box).high + vec3(margin);
    vec2 xy = rectangle_corner(vec2(high), corner);
    return vec3(xy.x, xy.y, ring == 0 ? -high.z : high.z);
}

Hit hit(Box box, Ray ray, int open_ends, int solver) {
    vec3 high = bounds(box).high;
    vec3 o = ray.origin;
    vec3 d = ray.direction;
    Span span = whole_line();
    span = below_plane(span, o.x + high.x, d.x, 0);
    span = below_plane(span, high.x - o.x, -d.x, 1);
    span = below_plane(span, o.y + high.y, d.y, 2);
    span = below_plane(span, high.y - o.y, -d.y, 3);
    span = below_plane(span, o.z + high.z, d.z, 4);
    span = below_plane(span, high.z - o.z, -d.z, 5);
    Crossing crossing = first_crossing(span, ray.first, 0);
    if (!crossing.found) {
        return miss();
    }
    return hit_at(ray, crossing.t, box_normal(crossing.face));
}
