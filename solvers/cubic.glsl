// Real roots of t^3 + b t^2 + c t + d in closed form: Viete's cosines where there are three,
// Cardano's cube roots where there is one (Abramowitz, Stegun 1964, section 3.8.2).
struct Roots3 {
    int count;      // 1 or 3
    real greatest;  // the only one where there is one
    real middle;
    real least;
};

real cube_root(real x) {
    real size = abs(x);
    real root = size > real(0) ? pow(size, real(1) / real(3)) : real(0);
    return x < real(0) ? -root : root;
}

// With t = z - b / 3: z^3 + 3 third z + 2 half_constant.
Roots3 solve_cubic(real b, real c, real d) {
    real shift = b / real(3);
    real third = c / real(3) - shift * shift;
    real half_constant = shift * shift * shift + real(0.5) * (d - shift * c);
    real discriminant = half_constant * half_constant + third * third * third;
    Roots3 roots;
    if (discriminant < real(0)) {
        real angle = atan(sqrt(-discriminant), -half_constant) / real(3);
        real size = real(2) * sqrt(max(real(0), -third));
        real turn = real(2) * pi() / real(3);
        roots.count = 3;
        roots.greatest = size * cos(angle) - shift;
        roots.middle = size * cos(angle - turn) - shift;
        roots.least = size * cos(angle + turn) - shift;
        return roots;
    }
    real root = sqrt(discriminant);
    // Of the two cubes the one whose terms do not cancel.
    real u = cube_root(half_constant > real(0) ? -half_constant - root : root - half_constant);
    real z = u == real(0) ? real(0) : u - third / u;
    roots.count = 1;
    roots.greatest = z - shift;
    roots.middle = roots.greatest;
    roots.least = roots.greatest;
    return roots;
}
