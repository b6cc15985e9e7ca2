// First root of a quartic or cubic in closed form: Ferrari 1545 by way of the resolvent cubic
// (Abramowitz, Stegun 1964, section 3.8.3). What the closed forms round off is not repaired.

// The root t, if it lies in [low, high] before the one known.
Root earlier_of(Root known, real t, real low, real high) {
    if (t >= low && t <= high && (!known.found || t < known.t)) {
        known = root_at(t, 0);
    }
    return known;
}

// The roots of t^2 + p t + q, moved by -shift.
Root earlier_of_pair(Root known, vec3 p_q_shift, real low, real high) {
    real half_p = real(0.5) * p_q_shift.x;
    real discriminant = half_p * half_p - p_q_shift.y;
    if (discriminant < real(0)) {
        return known;
    }
    Roots2 roots = solve_quadratic(real(1), half_p, p_q_shift.y, discriminant);
    known = earlier_of(known, roots.low - p_q_shift.z, low, high);
    return earlier_of(known, roots.high - p_q_shift.z, low, high);
}

// f / a4 with t = u - shift is u^4 + c u^2 + d u + e = (u^2 + p u + q) (u^2 - p u + s), where
// w = p^2 is the greatest root of w^3 + 2 c w^2 + (c^2 - 4 e) w - d^2.
Root first_quartic_root(Polynomial f, real low, real high) {
    real shift = real(0.25) * f.a3 / f.a4;
    real shift2 = shift * shift;
    real a2 = f.a2 / f.a4;
    real a1 = f.a1 / f.a4;
    real c = a2 - real(6) * shift2;
    real d = a1 - real(2) * shift * (a2 - real(4) * shift2);
    real e = f.a0 / f.a4 - shift * (a1 - shift * (a2 - real(3) * shift2));
    real w = max(real(0), solve_cubic(real(2) * c, c * c - real(4) * e, -d * d).greatest);
    real p = sqrt(w);
    // s - q is d / p, and by Vieta the root of its square: the larger divisor decides.
    real sum = c + w;
    real square = sum * sum - real(4) * e;
    real difference = sqrt(max(real(0), square));
    difference = d < real(0) ? -difference : difference;
    if (w > square && w > real(0)) {
        difference = d / p;
    }
    Root root = no_root(low, 0);
    root = earlier_of_pair(root, vec3(p, real(0.5) * (sum - difference), shift), low, high);
    return earlier_of_pair(root, vec3(-p, real(0.5) * (sum + difference), shift), low, high);
}

Root first_root_analytic(Polynomial f, Search search) {
    if (search.high <= search.low) {
        return no_root(search.low, 0);
    }
    Polynomial g = scaled(f, search.scale);
    // What the closed forms' rounding moves out of the interval is still the root.
    real low = (search.low - search.tolerance) / search.scale;
    real high = (search.high + search.tolerance) / search.scale;
    Root root = no_root(low, 0);
    if (g.a4 != real(0)) {
        root = first_quartic_root(g, low, high);
    } else if (g.a3 != real(0)) {
        Roots3 roots = solve_cubic(g.a2 / g.a3, g.a1 / g.a3, g.a0 / g.a3);
        root = earlier_of(root, roots.least, low, high);
        root = earlier_of(root, roots.middle, low, high);
        root = earlier_of(root, roots.greatest, low, high);
    }
    root.t = clamp(root.t * search.scale, search.low, search.high);
    return root;
}
