// Where a line crosses the wall of a torus, by whichever solver is chosen.

// Solvers without a flaw of their own are spared what the quartic loses in powers of t; the others
// get it as it is printed, so that a comparison shows what each of them does.
bool is_exact(int solver) {
    return solver == solver_convexity_split || solver == solver_bracketed;
}

// The quartic along p + t v, |v| = 1, p . v = 0: with t measured from the point closest to the
// centre it has no cubic term. Positive outside (reference: (|x|^2 - R^2 - r^2)^2 + 4 R^2 (z^2 -
// r^2)).
Polynomial torus_quartic(Torus torus, Ray line, bool nears_axis, int solver) {
    vec3 p = line.origin;
    vec3 v = line.direction;
    real bend2 = torus.bend_radius * torus.bend_radius;
    real radius2 = torus.radius * torus.radius;
    real weight = real(4) * bend2;
    real q = dot(p, p);
    real k = q - bend2 - radius2;
    real m = q + bend2 - radius2;
    // Near the axis of a fat torus the same sum with the distance from the axis instead of the
    // height, (|x|^2 + R^2 - r^2)^2 - 4 R^2 (x^2 + y^2), subtracts smaller numbers.
    bool near_axis = nears_axis && q < radius2;
    real e = near_axis ? m * m - weight * (p.x * p.x + p.y * p.y)
                       : k * k + weight * (p.z * p.z - radius2);
    Polynomial f = polynomial(real(1), real(0), real(2) * k + weight * v.z * v.z,
                              real(2) * weight * p.z * v.z, e);
    f.as_squares = is_exact(solver);
    f.k = k;
    f.weight = weight;
    f.offset = p.z;
    f.rate = v.z;
    f.limit = radius2;
    if (near_axis) {
        real across2 = v.x * v.x + v.y * v.y;
        real beside = p.x * v.y - p.y * v.x;
        bool upright = across2 <= rounding() * rounding();
        f.k = m;
        f.weight = upright ? -weight : -weight / across2;
        f.offset = upright ? real(0) : p.x * v.x + p.y * v.y;
        f.rate = upright ? real(0) : across2;
        f.limit = upright ? -(p.x * p.x + p.y * p.y) : -beside * beside;
    }
    return f;
}

// f as torus_quartic() makes it for this solver.
Root first_wall_root(Torus torus, Polynomial f, Ray line, Search search, int solver) {
    if (solver == solver_sphere_tracing || solver == solver_sphere_tracing_two_ray) {
        return march(torus, line, search, solver == solver_sphere_tracing_two_ray);
    }
    return first_root(f, search, solver);
}
