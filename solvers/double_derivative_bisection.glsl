// First root of a depressed quartic by halving where f or f' changes sign: de Toledo, Levy, Paul
// 2007, "Iterative methods for visualization of implicit surfaces on GPU", section 4.2.
//
// The derivative's halving finds up to two roots around a single dip, so the search is cut in two
// where the third derivative vanishes: at 0, because f is depressed. That place only lies near the
// hump between two dips: a half may hold three roots, and then a later one than the first may be
// found.

// From a torus's width to 1e-7 of a tube a thousandth as thick takes 36.
const int halvings_max = 48;

Root derivative_bisection(Quartic f, real low, real high, real tolerance) {
    Root root;
    root.found = false;
    root.t = low;
    if (high <= low) {
        return root;
    }
    real side = quartic_value(f, low) < real(0) ? real(-1) : real(1);
    root.found = side * quartic_value(f, high) < real(0);
    for (int i = 0; i < halvings_max && high - low > tolerance; ++i) {
        real middle = real(0.5) * (low + high);
        bool crossed = side * quartic_value(f, middle) < real(0);
        root.found = root.found || crossed;
        // Once the sign has changed it decides; until then the slope tells where the dip is.
        bool before = root.found ? crossed : side * quartic_slope(f, middle) >= real(0);
        high = before ? middle : high;
        low = before ? low : middle;
    }
    root.t = real(0.5) * (low + high);
    return root;
}

Root first_root_double_derivative_bisection(Quartic f, Search search) {
    real middle = clamp(real(0), search.low, max(search.low, search.high));
    Root root = derivative_bisection(f, search.low, middle, search.tolerance);
    if (!root.found) {
        root = derivative_bisection(f, middle, search.high, search.tolerance);
    }
    return root;
}
