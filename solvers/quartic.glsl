// The depressed quartic t^4 + c t^2 + d t + e, which a torus gives when t is measured from its
// centre.
struct Quartic {
    real c;
    real d;
    real e;
};

// A root, or none in the interval that was asked for.
struct Root {
    bool found;
    real t;
};

// Where to look for a root, and how closely.
struct Search {
    real low;
    real high;
    real tolerance;  // > 0: a step this small ends a search
    real scale;      // > 0: how large the curve is; a torus's bend_radius + radius
};

real quartic_value(Quartic f, real t) {
    return ((t * t + f.c) * t + f.d) * t + f.e;
}

real quartic_slope(Quartic f, real t) {
    return (real(4) * t * t + real(2) * f.c) * t + f.d;
}
