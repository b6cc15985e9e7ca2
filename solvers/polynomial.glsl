// The quartic or cubic a4 t^4 + a3 t^3 + a2 t^2 + a1 t + a0 along a ray, and what solvers say of
// it.
//
// A torus's is also a sum of squares, (t^2 + k)^2 + weight ((offset + rate t)^2 - limit), which
// loses fewer digits: where the tube is thin, powers of t cancel to R^2 / r^2 roundings, squares to
// R / r.
struct Polynomial {
    real a4;  // 0: a cubic
    real a3;
    real a2;
    real a1;
    real a0;
    bool as_squares;  // evaluated by the five below; then a4 = 1 and a3 = 0
    real k;
    real weight;
    real offset;
    real rate;
    real limit;
};

Polynomial polynomial(real a4, real a3, real a2, real a1, real a0) {
    Polynomial f;
    f.a4 = a4;
    f.a3 = a3;
    f.a2 = a2;
    f.a1 = a1;
    f.a0 = a0;
    f.as_squares = false;
    f.k = real(0);
    f.weight = real(0);
    f.offset = real(0);
    f.rate = real(0);
    f.limit = real(0);
    return f;
}

// A root, or none in the interval that was asked for.
struct Root {
    bool found;
    real t;
    int steps;  // of the solver's loops
};

Root no_root(real t, int steps) {
    Root root;
    root.found = false;
    root.t = t;
    root.steps = steps;
    return root;
}

Root root_at(real t, int steps) {
    Root root;
    root.found = true;
    root.t = t;
    root.steps = steps;
    return root;
}

// Where to look for a root, and how closely.
struct Search {
    real low;
    real high;
    real tolerance;     // > 0: a step this small ends a search
    real scale;         // > 0: how large the curve is; a torus's bend_radius + radius
    real resolution;    // >= 0: how far a root may be off, for solvers that adapt to the distance
    bool starts_above;  // known to start where f > 0
};

real value_at(Polynomial f, real t) {
    if (f.as_squares) {
        real outer = t * t + f.k;
        real height = f.offset + f.rate * t;
        return outer * outer + f.weight * (height * height - f.limit);
    }
    return (((f.a4 * t + f.a3) * t + f.a2) * t + f.a1) * t + f.a0;
}

// The first derivative.
real slope_at(Polynomial f, real t) {
    if (f.as_squares) {
        return real(4) * t * (t * t + f.k) + real(2) * f.weight * f.rate * (f.offset + f.rate * t);
    }
    return ((real(4) * f.a4 * t + real(3) * f.a3) * t + real(2) * f.a2) * t + f.a1;
}

// The second derivative.
real bend_at(Polynomial f, real t) {
    return (real(12) * f.a4 * t + real(6) * f.a3) * t + real(2) * f.a2;
}

// Where the bend changes its sign; a cubic's other place is at -huge or huge. Two equal ones where
// it never does.
Roots2 inflections(Polynomial f) {
    if (f.as_squares) {
        Roots2 places;
        places.high = sqrt(max(real(0), -f.a2) / real(6));
        places.low = -places.high;
        return places;
    }
    real half_b = real(1.5) * f.a3;
    real a = real(6) * f.a4;
    real discriminant = half_b * half_b - a * f.a2;
    // Without an inflection: a double root of 6 a4 t^2 + 3 a3 t + c.
    real c = discriminant < real(0) ? half_b * half_b / a : f.a2;
    return solve_quadratic(a, half_b, c, max(real(0), discriminant));
}

// Whether the bend is positive beyond both inflections (of a cubic: beyond the one at a finite
// place), negative between them; else the other way round.
bool is_convex_outside(Polynomial f) {
    return f.a4 > real(0) || (f.a4 == real(0) && (f.a3 != real(0) || f.a2 > real(0)));
}

// The same curve with t measured in this size, divided by its fourth power.
Polynomial scaled(Polynomial f, real size) {
    real inverse = real(1) / size;
    real inverse2 = inverse * inverse;
    return polynomial(f.a4, f.a3 * inverse, f.a2 * inverse2, f.a1 * inverse2 * inverse,
                      f.a0 * inverse2 * inverse2);
}
