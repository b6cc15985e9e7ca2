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

real quartic_bend(Quartic f, real t) {
    return real(12) * t * t + real(2) * f.c;
}

// The same curve with t measured in this size.
Quartic scaled_quartic(Quartic f, real size) {
    real inverse = real(1) / size;
    real inverse2 = inverse * inverse;
    f.c = f.c * inverse2;
    f.d = f.d * inverse2 * inverse;
    f.e = f.e * inverse2 * inverse2;
    return f;
}
