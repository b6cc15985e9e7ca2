// First root of a depressed quartic in closed form: Ferrari 1545 by way of the resolvent cubic,
// with Viete's cosine where that has three roots (Abramowitz, Stegun 1964, sections 3.8.2, 3.8.3).
//
// f = (t^2 + p t + q) (t^2 - p t + s) where w = p^2 is the greatest root of
// w^3 + 2 c w^2 + (c^2 - 4 e) w - d^2. What the cubic's closed form rounds off is not repaired.

real cube_root(real x) {
    real size = abs(x);
    real root = size > real(0) ? pow(size, real(1) / real(3)) : real(0);
    return x < real(0) ? -root : root;
}

real greatest_resolvent_root(Quartic f) {
    real third = -f.c * f.c / real(9) - real(4) * f.e / real(3);
    real half_constant =
        -f.c * f.c * f.c / real(27) + real(4) * f.c * f.e / real(3) - real(0.5) * f.d * f.d;
    real discriminant = half_constant * half_constant + third * third * third;
    real z;
    if (discriminant < real(0)) {
        real angle = atan(sqrt(-discriminant), -half_constant) / real(3);
        z = real(2) * sqrt(max(real(0), -third)) * cos(angle);
    } else {
        real root = sqrt(discriminant);
        // Of the two cubes the one whose terms do not cancel.
        real u = cube_root(half_constant > real(0) ? -half_constant - root : root - half_constant);
        z = u == real(0) ? real(0) : u - third / u;
    }
    return max(real(0), z - real(2) * f.c / real(3));
}

// The first root of t^2 + p t + q in [low, high] that lies before the one known.
Root earlier_root(Root known, real p, real q, real low, real high) {
    real half_p = real(0.5) * p;
    real discriminant = half_p * half_p - q;
    if (discriminant < real(0)) {
        return known;
    }
    Roots2 roots = solve_quadratic(real(1), half_p, q, discriminant);
    real t = roots.low >= low ? roots.low : roots.high;
    if (t >= low && t <= high && (!known.found || t < known.t)) {
        known.found = true;
        known.t = t;
    }
    return known;
}

Root first_root_analytic(Quartic f, Search search) {
    Quartic g = scaled_quartic(f, search.scale);
    real w = greatest_resolvent_root(g);
    real p = sqrt(w);
    // s - q is d / p, and by Vieta the root of its square: the larger divisor decides.
    real sum = g.c + w;
    real square = sum * sum - real(4) * g.e;
    real difference = sqrt(max(real(0), square));
    difference = g.d < real(0) ? -difference : difference;
    if (w > square && w > real(0)) {
        difference = g.d / p;
    }
    // What the cubic's rounding moves out of the interval is still the root.
    real low = (search.low - search.tolerance) / search.scale;
    real high = (search.high + search.tolerance) / search.scale;
    Root root;
    root.found = false;
    root.t = low;
    if (search.high <= search.low) {
        return root;
    }
    root = earlier_root(root, p, real(0.5) * (sum - difference), low, high);
    root = earlier_root(root, -p, real(0.5) * (sum + difference), low, high);
    root.t = clamp(root.t * search.scale, search.low, search.high);
    return root;
}
