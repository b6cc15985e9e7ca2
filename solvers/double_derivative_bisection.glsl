// First root of a torus's quartic by halving where f or f' changes sign: de Toledo, Levy, Paul
// 2007, "Iterative methods for visualization of implicit surfaces on GPU", section 4.2.
//
// The derivative's halving finds up to two roots around a single dip, so the search is cut in two
// where the third derivative vanishes: at 0, because a torus's f has no cubic term. That place only
// lies near the hump between two dips: a half may hold three roots, and then a later one than the
// first may be found.

// From a torus's width to 1e-7 of a tube a thousandth as thick takes 36.
const int halvings_max = 48;

Root derivative_bisection(Polynomial f, real low, real high, real tolerance) {
    Root root = no_root(low, 0);
    if (high <= low) {
        return root;
    }
    real side = value_at(f, low) < real(0) ? real(-1) : real(1);
    root.found = side * value_at(f, high) < real(0);
    for (int i = 0; i < halvings_max && high - low > tolerance; ++i) {
        root.steps = i + 1;
        real middle = real(0.5) * (low + high);
        bool crossed = side * value_at(f, middle) < real(0);
        root.found = root.found || crossed;
        // Once the sign has changed it decides; until then the slope tells where the dip is.
        bool before = root.found ? crossed : side * slope_at(f, middle) >= real(0);
        high = before ? middle : high;
        low = before ? low : middle;
    }
    root.t = real(0.5) * (low + high);
    return root;
}

Root first_root_double_derivative_bisection(Polynomial f, Search search) {
    real middle = clamp(real(0), search.low, max(search.low, search.high));
    Root root = derivative_bisection(f, search.low, middle, search.tolerance);
    if (!root.found) {
        int before = root.steps;
        root = derivative_bisection(f, middle, search.high, search.tolerance);
        root.steps = root.steps + before;
    }
    return root;
}
