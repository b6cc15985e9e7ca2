// The part of a line inside a convex solid, and which face it enters and leaves by.
//
// Faces: 0 is the wall, 1 + i is the cap of end i, for every convex shape. Intersecting spans makes
// solids watertight: wherever a line leaves one face it enters its neighbour at the same number.
struct Span {
    real enter;  // empty where enter > exit
    real exit;
    int enter_face;
    int exit_face;
};

// One point of a line on the boundary of a solid.
struct Crossing {
    bool found;
    real t;
    int face;
};

Span whole_line() {
    Span span;
    span.enter = -huge;
    span.exit = huge;
    span.enter_face = 0;
    span.exit_face = 0;
    return span;
}

Span empty_span() {
    Span span = whole_line();
    span.enter = huge;
    span.exit = -huge;
    return span;
}

// Keeps what lies between two parameters; ties go to the new face.
Span between(Span span, real low, real high, int face) {
    if (low >= span.enter) {
        span.enter = low;
        span.enter_face = face;
    }
    if (high <= span.exit) {
        span.exit = high;
        span.exit_face = face;
    }
    return span;
}

// Keeps where depth + rate t >= 0: the inner side of a plane at this depth below it.
Span below_plane(Span span, real depth, real rate, int face) {
    if (abs(depth) >= huge * abs(rate)) {
        if (depth < real(0)) {
            span.exit = -huge;
            span.enter = huge;
        }
        return span;
    }
    real t = -depth / rate;
    return rate > real(0) ? between(span, t, huge, face) : between(span, -huge, t, face);
}

// Keeps where |depth + rate t| <= reach.
Span between_planes(Span span, real depth, real rate, real reach) {
    return below_plane(below_plane(span, reach + depth, rate, 0), reach - depth, -rate, 0);
}

// Inside the sphere of this radius around the local origin. The line is measured from its closest
// point, so that nothing cancels.
Span in_sphere(vec3 o, vec3 d, real radius) {
    real dd = dot(d, d);
    real middle = -dot(o, d) / dd;
    vec3 closest = o + middle * d;
    real room = radius * radius - dot(closest, closest);
    if (room < real(0)) {
        return empty_span();
    }
    real reach = sqrt(room / dd);
    return between(whole_line(), middle - reach, middle + reach, 0);
}

// Inside the cone x^2 + y^2 <= z^2, z >= 0, in the space where z is the wall's radius at that
// height: with (o, d) the line's image there. A cylinder has d.z = 0. The discriminant as a sum of
// squared cross products (Lagrange's identity for the form (1, 1, -1)) keeps its digits where b^2 -
// a c loses them.
Span in_cone(vec3 o, vec3 d) {
    vec3 sign_z = vec3(1, 1, -1);
    real a = dot(d * sign_z, d);
    real b = dot(o * sign_z, d);
    real c = dot(o * sign_z, o);
    vec3 m = cross(o, d);
    real discriminant = dot(m * sign_z, m);
    if (a == real(0) && b == real(0)) {
        Span all = whole_line();
        if (c > real(0) || o.z < real(0)) {
            all = empty_span();
        }
        return all;
    }
    if (discriminant < real(0)) {
        if (a > real(0)) {
            return empty_span();
        }
        discriminant = real(0);
    }
    Roots2 roots = solve_quadratic(a, b, c, discriminant);
    if (a < real(0)) {
        return d.z > real(0) ? between(whole_line(), roots.high, huge, 0)
                             : between(whole_line(), -huge, roots.low, 0);
    }
    bool upper = o.z + real(0.5) * (roots.low + roots.high) * d.z >= real(0);
    if (upper) {
        return between(whole_line(), roots.low, roots.high, 0);
    }
    return empty_span();
}

bool is_drawn(int face, int open_ends) {
    return face == 0 || !is_open(open_ends, face - 1);
}

// The first crossing that is seen: the way in, or, from inside or through an open end, the way out.
Crossing first_crossing(Span span, real first, int open_ends) {
    Crossing crossing;
    crossing.found = false;
    crossing.t = span.enter;
    crossing.face = span.enter_face;
    if (span.enter > span.exit) {
        return crossing;
    }
    if (span.enter >= first && is_drawn(span.enter_face, open_ends)) {
        crossing.found = true;
        return crossing;
    }
    crossing.t = span.exit;
    crossing.face = span.exit_face;
    crossing.found = span.exit >= first && is_drawn(span.exit_face, open_ends);
    return crossing;
}
