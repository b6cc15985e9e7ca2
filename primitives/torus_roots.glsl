// Where a line crosses the wall of a torus, by whichever solver is chosen.

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
