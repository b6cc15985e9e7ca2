// An elbow: a tube around a circle in the local xy plane, from +x through arc; end 0 faces -y, end
// 1 is at the arc.
//
// A ring (arc of a full turn) has no ends. The tube may touch the axis (bend_radius = radius) but
// not cross it: spindle tori are refused by is_valid in shape.cpp.
struct Torus {
    real bend_radius;  // >= radius
    real radius;       // > 0, of the tube
    real arc;          // (0, 2 pi]
    real unused_0;
};

Bounds bounds(Torus torus) {
    vec4 xy =
        sector_box(torus.bend_radius - torus.radius, torus.bend_radius + torus.radius, torus.arc);
    Bounds box;
    box.low = vec3(xy.x, xy.y, -torus.radius);
    box.high = vec3(xy.z, xy.w, torus.radius);
    return box;
}

bool is_ring(Torus torus) {
    return torus.arc >= real(2) * pi();
}

int face_count(Torus torus) {
    return is_ring(torus) ? 1 : 3;
}

int end_count(Torus torus) {
    return is_ring(torus) ? 0 : 2;
}

End end(Torus torus, int index) {
    real angle = index == 0 ? real(0) : torus.arc;
    real side = index == 0 ? real(-1) : real(1);
    End disc;
    disc.centre = polar(torus.bend_radius, angle, real(0));
    disc.normal = side * vec3(-sin(angle), cos(angle), 0);
    disc.radius = torus.radius;
    disc.flare = real(0);
    return disc;
}

vec3 point(Torus torus, int face, vec2 uv) {
    if (face == 0) {
        real around = real(2) * pi() * uv.y;
        return polar(torus.bend_radius + torus.radius * cos(around), torus.arc * uv.x,
                     torus.radius * sin(around));
    }
    return disc_point(end(torus, face - 1), uv);
}

int hull_rings(Torus torus) {
    return arc_rings(torus.arc);
}

vec3 hull_point(Torus torus, int ring, int corner, real margin) {
    vec3 tube = octagon_corner(torus.radius + margin, corner, real(0));
    vec2 across_tube = vec2(torus.bend_radius + tube.x, tube.y);
    if (tube.x < real(0)) {
        // The inner side need not be widened: its chords pass inside.
        across_tube.x = across_tube.x * cos(real(0.5) * torus.arc / real(hull_rings(torus) - 1));
    }
    return arc_hull_point(across_tube, torus.arc, hull_rings(torus), ring, margin);
}

// The quartic along p + t v, |v| = 1, p . v = 0: with t measured from the point closest to the
// centre it has no cubic term. Positive outside (reference: (|x|^2 - R^2 - r^2)^2 + 4 R^2 (z^2 -
// r^2)).
Quartic torus_quartic(real bend_radius, real radius, vec3 p, vec3 v) {
    real bend2 = bend_radius * bend_radius;
    real radius2 = radius * radius;
    real q = dot(p, p);
    real k = q - bend2 - radius2;
    Quartic f;
    f.c = real(2) * k + real(4) * bend2 * v.z * v.z;
    f.d = real(8) * bend2 * p.z * v.z;
    f.e = k * k + real(4) * bend2 * (p.z * p.z - radius2);
    // Near the axis of a fat torus the other way to write the constant term subtracts smaller
    // numbers.
    real m = q + bend2 - radius2;
    if (m * m + real(4) * bend2 * q < k * k + real(4) * bend2 * radius2) {
        f.e = m * m - real(4) * bend2 * (p.x * p.x + p.y * p.y);
    }
    return f;
}

// Outwards from the circle in the middle of the tube; its length is the distance from it.
vec3 from_spine(Torus torus, vec3 p) {
    real rho = length(vec2(p));
    if (rho == real(0)) {
        return vec3(-torus.bend_radius, 0, p.z);  // on the axis all directions are alike
    }
    real scale = real(1) - torus.bend_radius / rho;
    return vec3(p.x * scale, p.y * scale, p.z);
}

// Steps of polishing that still converge; where the line passes the tube by, they never do.
const int polish_steps_max = 8;

// Improves a root near t on the squared distance from the spine, taken as a quadratic: float32
// quartics of thin tori are only good to R^2 / r^2 ulps. side -1 is the way in, 1 the way out; not
// found where the line passes by.
Root polish(Torus torus, vec3 p, vec3 v, real t, real side) {
    Root root;
    root.found = false;
    root.t = t;
    for (int i = 0; i < polish_steps_max && !root.found; ++i) {
        vec3 q = p + root.t * v;
        real rho =
            max(length(vec2(q)), real(0.01) * torus.bend_radius);  // the tube is not near the axis
        real w = rho - torus.bend_radius;
        real rho_slope = dot(vec2(q), vec2(v)) / rho;
        real bending = (v.x * v.x + v.y * v.y - rho_slope * rho_slope) / rho;
        real a = rho_slope * rho_slope + w * bending +
                 v.z * v.z;  // negative along the inner side of the bend
        real b = w * rho_slope + q.z * v.z;
        real distance = sqrt(w * w + q.z * q.z);
        real c = (distance - torus.radius) * (distance + torus.radius);
        real discriminant = b * b - a * c;
        real root_slope = side * sqrt(max(real(0), discriminant));
        // The form whose terms do not cancel; it needs no a where a vanishes.
        real divisor = b * side >= real(0) ? b + root_slope : a;
        real dividend = b * side >= real(0) ? -c : root_slope - b;
        if (discriminant < real(0)) {
            dividend = -b;
            divisor = a;
        }
        real change = dividend / (divisor == real(0) ? real(1) : divisor);
        root.t = root.t + clamp(change, -torus.radius, torus.radius);
        root.found = discriminant >= real(0) && abs(change) < last_step() * torus.radius;
    }
    return root;
}

bool is_inside(Torus torus, vec3 p) {
    return length(from_spine(torus, p)) < torus.radius;
}

bool lies_in(Root root, real low, real high) {
    return root.found && root.t >= low && root.t <= high;
}

// By how much the float quartic may misplace the wall of a thin tube.
real quartic_slack(Torus torus) {
    return real(2) * rounding() * torus.bend_radius * torus.bend_radius / torus.radius;
}

// A line passes through a tube at most twice; one visit more for a start in the slack.
const int torus_visits_max = 3;

Search wall_search(Torus torus, real low, real high) {
    Search search;
    search.low = low;
    search.high = high;
    search.tolerance = last_step() * torus.radius;
    search.scale = torus.bend_radius + torus.radius;
    return search;
}

// The wall's first crossing in [low, high] of the line p + t v for a tube so thin that the float32
// quartic errs by a visible part of it: the quartic of a tube thicker by that error finds every
// visit, polishing decides.
Root first_thin_root(Torus torus, vec3 p, vec3 v, real low, real high, int solver) {
    Search search = wall_search(torus, low, high);
    real skip =
        real(0.05) * torus.radius;  // over the rounding at a root; visits this short touch nothing
    Quartic f = torus_quartic(torus.bend_radius, torus.radius + quartic_slack(torus), p, v);
    bool inside = is_inside(torus, p + low * v);
    real from = low;
    Root root;
    root.found = false;
    root.t = low;
    for (int visit = 0; visit < torus_visits_max && !root.found; ++visit) {
        if (!inside) {
            Root way_in;
            way_in.found = true;
            way_in.t = from;
            if (quartic_value(f, from) >= real(0)) {
                search.low = from;
                way_in = first_root(f, search, solver);
            }
            if (!way_in.found) {
                return root;
            }
            root = polish(torus, p, v, way_in.t, real(-1));
            root.found = lies_in(root, low, high);
            from = way_in.t + skip;
        }
        if (!root.found && (inside || quartic_value(f, from) < real(0))) {
            search.low = from;
            Root way_out = first_root(f, search, solver);
            real last = way_out.found ? way_out.t : high;
            if (inside) {
                root = polish(torus, p, v, last, real(1));
                root.found = lies_in(root, low, high);
                inside = false;
            }
            from = last + skip;
        }
        if (from >= high) {
            return root;
        }
    }
    return root;
}

// Steps of marching; along a silhouette they become ever shorter.
const int marching_steps_max = 128;

// Marches by the distance from the wall: Hart 1996, "Sphere tracing", as in de Toledo, Levy, Paul
// 2007, section 4.3. With two starts the march goes on from the place nearest to the centre once
// the distance grows. It stops beside the wall, so that a silhouette is fatter by the tolerance.
Root march(Torus torus, vec3 p, vec3 v, Search search, bool two_starts) {
    Root root;
    root.found = false;
    root.t = search.low;
    real before = huge;
    for (int i = 0; i < marching_steps_max; ++i) {
        real distance = abs(length(from_spine(torus, p + root.t * v)) - torus.radius);
        if (distance < search.tolerance) {
            root.found = root.t <= search.high;
            return root;
        }
        bool restarts = two_starts && distance > before && root.t < real(0);
        before = restarts ? huge : distance;
        root.t = restarts ? real(0) : root.t + distance;
        if (root.t > search.high) {
            return root;
        }
    }
    return root;
}

// Solvers without a flaw of their own are spared the quartic's rounding; the others get the plain
// quartic, so that a comparison shows what each of them does.
Root first_wall_root(Torus torus, vec3 p, vec3 v, real low, real high, int solver) {
    bool exact = solver == solver_convexity_split || solver == solver_bracketed;
    if (exact && torus.bend_radius > real(2) * torus.radius) {
        return first_thin_root(torus, p, v, low, high, solver);
    }
    Search search = wall_search(torus, low, high);
    if (exact) {
        // Where the tube nearly meets the axis it bends far more sharply than its radius says.
        real sharpest = clamp(length(p), real(0.001) * torus.radius, torus.radius);
        search.tolerance = last_step() * sharpest;
    }
    if (solver == solver_sphere_tracing || solver == solver_sphere_tracing_two_ray) {
        return march(torus, p, v, search, solver == solver_sphere_tracing_two_ray);
    }
    return first_root(torus_quartic(torus.bend_radius, torus.radius, p, v), search, solver);
}

// The first crossing with what lies in [low, high] between two cuts, the end planes where they cut:
// cap, wall, cap.
Crossing first_crossing(Torus torus, Ray line, Span cut, int open_ends, int solver) {
    Crossing crossing;
    crossing.found = false;
    crossing.t = cut.enter;
    crossing.face = cut.enter_face;
    if (cut.enter >= cut.exit) {
        return crossing;
    }
    if (cut.enter_face > 0 && is_drawn(cut.enter_face, open_ends) &&
        is_inside(torus, at(line, cut.enter))) {
        crossing.found = true;
        return crossing;
    }
    Root root = first_wall_root(torus, line.origin, line.direction, cut.enter, cut.exit, solver);
    crossing.found = root.found;
    crossing.t = root.t;
    crossing.face = 0;
    if (!root.found && cut.exit_face > 0 && is_drawn(cut.exit_face, open_ends)) {
        crossing.found = is_inside(torus, at(line, cut.exit));
        crossing.t = cut.exit;
        crossing.face = cut.exit_face;
    }
    return crossing;
}

Hit hit(Torus torus, Ray ray, int open_ends, int solver) {
    // The same line with a unit direction, measured from its point closest to the centre.
    real speed = length(ray.direction);
    Ray line;
    line.direction = ray.direction / speed;
    real shift = dot(ray.origin, line.direction);
    line.origin = ray.origin - shift * line.direction;
    line.first = ray.first * speed + shift;

    real outer = torus.bend_radius + torus.radius + quartic_slack(torus);
    real room = outer * outer - dot(line.origin, line.origin);
    if (room < real(0)) {
        return miss();
    }
    real reach = real(1.00001) * sqrt(room);
    real turn = joint_overlap(torus.radius, real(0)) / torus.bend_radius;
    Sector sector =
        in_sector(line.origin, line.direction, torus.arc, is_open(open_ends, 0) ? turn : real(0),
                  is_open(open_ends, 1) ? turn : real(0));
    real low = max(-reach, line.first);
    Crossing crossing =
        first_crossing(torus, line, between(sector.part_0, low, reach, 0), open_ends, solver);
    if (!crossing.found) {
        crossing =
            first_crossing(torus, line, between(sector.part_1, low, reach, 0), open_ends, solver);
    }
    if (!crossing.found) {
        return miss();
    }
    vec3 normal = from_spine(torus, at(line, crossing.t));
    if (crossing.face > 0) {
        normal = end(torus, crossing.face - 1).normal;
    }
    Hit result = hit_at(line, crossing.t, normal);
    result.t = (crossing.t - shift) / speed;
    return result;
}
