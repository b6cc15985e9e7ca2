// A reducer: an oblique cone between a circle at z = -height / 2 and one at z = height / 2, cut by
// two planes.
//
// The lower circle is centred on (-offset / 2, 0), the upper one on (offset / 2, 0): the frame is
// turned so that an eccentric reducer leans along x. Each end plane passes through its circle's
// centre and rises by its slopes along x and y; a plane that is not level makes that end an ellipse
// on the same cone (a mitre). snout_is_valid() says which parameters enclose a finite solid.
struct Snout {
    real bottom_radius;   // >= 0; at least one radius > 0
    real top_radius;      // >= 0
    real height;          // > 0
    real offset;          // of the upper circle against the lower one
    real bottom_slope_x;  // tangent of the cut angle
    real bottom_slope_y;
    real top_slope_x;
    real top_slope_y;
};

real radius_slope(Snout snout) {
    return (snout.top_radius - snout.bottom_radius) / snout.height;
}

// Radius of the cone at a height, continued beyond the circles where a cut needs it.
real radius_at(Snout snout, real z) {
    return real(0.5) * (snout.bottom_radius + snout.top_radius) + radius_slope(snout) * z;
}

// Height of the end plane over the point of the wall at this angle: z = z0 + slope . (x, y) on the
// wall's own circle.
real end_height(Snout snout, int index, real angle) {
    real side = index == 0 ? real(-1) : real(1);
    real along = index == 0 ? snout.bottom_slope_x * cos(angle) + snout.bottom_slope_y * sin(angle)
                            : snout.top_slope_x * cos(angle) + snout.top_slope_y * sin(angle);
    real lean =
        (index == 0 ? snout.bottom_slope_x : snout.top_slope_x) * snout.offset / snout.height;
    real radius = index == 0 ? snout.bottom_radius : snout.top_radius;
    real rise = along * radius / (real(1) - along * radius_slope(snout) - lean);
    return side * real(0.5) * snout.height + rise;
}

vec3 wall_point(Snout snout, real angle, real z) {
    vec3 p = polar(radius_at(snout, z), angle, z);
    p.x = p.x + snout.offset * z / snout.height;
    return p;
}

// The most that an end's rim departs from its circle's plane; huge where the cut does not close.
real end_rise(Snout snout, int index) {
    real slope_x = index == 0 ? snout.bottom_slope_x : snout.top_slope_x;
    real slope_y = index == 0 ? snout.bottom_slope_y : snout.top_slope_y;
    real slope = sqrt(slope_x * slope_x + slope_y * slope_y);
    real radius = index == 0 ? snout.bottom_radius : snout.top_radius;
    real closing =
        real(1) - slope * abs(radius_slope(snout)) - abs(slope_x * snout.offset) / snout.height;
    return closing > real(0.01) ? slope * radius / closing : huge;
}

// Whether both cuts close: each is an ellipse, not a hyperbola that runs away.
bool snout_is_valid(Snout snout) {
    return snout.height > real(0) && end_rise(snout, 0) < huge && end_rise(snout, 1) < huge;
}

// The least and the greatest of (a cos t + b sin t) / (w - p cos t - q sin t), w > |(p, q)|: m is
// reached where (a + m p) cos t + (b + m q) sin t = m w has a solution t, that is up to (a + m p)^2
// + (b + m q)^2 = m^2 w^2.
vec2 quotient_range(vec2 ab, vec2 pq, real w) {
    real h = dot(ab, pq);
    real k = w * w - dot(pq, pq);
    real root = sqrt(h * h + k * dot(ab, ab));
    return vec2(h - root, h + root) / k;
}

// The tight box of an end's rim: as seen from the circle's centre, its points are the radius times
// such quotients.
Bounds rim_bounds(Snout snout, int index) {
    vec2 slope = index == 0 ? vec2(snout.bottom_slope_x, snout.bottom_slope_y)
                            : vec2(snout.top_slope_x, snout.top_slope_y);
    real side = index == 0 ? real(-0.5) : real(0.5);
    real radius = index == 0 ? snout.bottom_radius : snout.top_radius;
    real lean = snout.offset / snout.height;
    real w = real(1) - slope.x * lean;
    vec2 pq = slope * radius_slope(snout);
    vec2 x = quotient_range(vec2(w + lean * slope.x, lean * slope.y), pq, w);
    vec2 y = quotient_range(vec2(0, w), pq, w);
    vec2 z = quotient_range(slope, pq, w);
    vec3 centre = vec3(side * snout.offset, 0, side * snout.height);
    Bounds box;
    box.low = centre + radius * vec3(x.x, y.x, z.x);
    box.high = centre + radius * vec3(x.y, y.y, z.y);
    return box;
}

Bounds bounds(Snout snout) {
    Bounds bottom = rim_bounds(snout, 0);
    Bounds top = rim_bounds(snout, 1);
    Bounds box;
    box.low = min(bottom.low, top.low);
    box.high = max(bottom.high, top.high);
    return box;
}

int face_count(Snout snout) {
    return 3;
}

int end_count(Snout snout) {
    return 2;
}

// A sheared end is no disc: its radius is given as 0, which nothing joins.
End end(Snout snout, int index) {
    bool level = index == 0 ? snout.bottom_slope_x == real(0) && snout.bottom_slope_y == real(0)
                            : snout.top_slope_x == real(0) && snout.top_slope_y == real(0);
    real radius = index == 0 ? snout.bottom_radius : snout.top_radius;
    End disc = upright_end(index, snout.height, level ? radius : real(0), radius_slope(snout));
    disc.centre.x = (index == 0 ? real(-0.5) : real(0.5)) * snout.offset;
    if (snout.offset != real(0)) {
        disc.flare = huge;
    }
    return disc;
}

vec3 point(Snout snout, int face, vec2 uv) {
    real angle = real(2) * pi() * (face == 1 ? -uv.x : uv.x);
    if (face == 0) {
        real low = end_height(snout, 0, angle);
        return wall_point(snout, angle, mix(low, max(low, end_height(snout, 1, angle)), uv.y));
    }
    vec3 rim = wall_point(snout, angle, end_height(snout, face - 1, angle));
    return mix(rim, end(snout, face - 1).centre, uv.y);
}

Hit hit(Snout snout, Ray ray, int open_ends, int solver) {
    real slope = radius_slope(snout);
    real lean = snout.offset / snout.height;
    real overlap =
        joint_overlap(max(snout.bottom_radius, snout.top_radius), abs(slope) + abs(lean));
    real half_height = real(0.5) * snout.height;
    real low = wall_reach(open_ends, 0, half_height, overlap);
    real high = wall_reach(open_ends, 1, half_height, overlap);
    vec3 o = ray.origin;
    vec3 d = ray.direction;

    Span span = in_cone(vec3(o.x - lean * o.z, o.y, radius_at(snout, o.z)),
                        vec3(d.x - lean * d.z, d.y, slope * d.z));
    vec3 bottom = vec3(-snout.bottom_slope_x, -snout.bottom_slope_y, 1);
    vec3 top = vec3(snout.top_slope_x, snout.top_slope_y, -1);
    real half_offset = real(0.5) * snout.offset;
    span = below_plane(span, dot(bottom, o + vec3(half_offset, 0, low)), dot(bottom, d), 1);
    span = below_plane(span, dot(top, o - vec3(half_offset, 0, high)), dot(top, d), 2);
    Crossing crossing = first_crossing(span, ray.first, open_ends);
    if (!crossing.found) {
        return miss();
    }
    vec3 p = at(ray, crossing.t);
    vec2 across_axis = vec2(p.x - lean * p.z, p.y);
    real rho = length(across_axis);
    vec3 normal = vec3(0, 0, slope < real(0) ? 1 : -1);
    if (rho > real(0)) {
        normal = vec3(across_axis.x, across_axis.y, -slope * rho - lean * across_axis.x);
    }
    if (crossing.face > 0) {
        normal = crossing.face == 1 ? -bottom : -top;
    }
    return hit_at(ray, crossing.t, normal);
}
