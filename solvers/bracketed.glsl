// First root of a depressed quartic by intervals in which it is monotone, after Yuksel 2022,
// "High-performance polynomial root finding for graphics", Proc. ACM CGIT 5(3).
//
// The roots of the derivative cut the search into monotone pieces, and a piece whose ends differ in
// sign holds one root: Newton from the middle, kept in a bracket that halves where Newton would
// leave it. The derivative's own roots are found alike between the inflections -s and s, where it
// is monotone.

// Newton needs 4 to 8 steps; the rest is for the halvings at double roots.
const int bracketed_steps_max = 48;

// The root of side * f, or with slopes of side * f', between a place where it is not negative and
// one where it is, whichever comes first.
real bracketed_root(Quartic f, bool slopes, real side, Search search) {
    real low = search.low;
    real high = search.high;
    real t = real(0.5) * (low + high);
    for (int i = 0; i < bracketed_steps_max; ++i) {
        real value = side * (slopes ? quartic_slope(f, t) : quartic_value(f, t));
        real slope = side * (slopes ? quartic_bend(f, t) : quartic_slope(f, t));
        low = value >= real(0) ? t : low;
        high = value >= real(0) ? high : t;
        // Only a step of Newton tells how near the root is, a halving does not.
        if (abs(value) < search.tolerance * abs(slope)) {
            return clamp(t - value / slope, low, high);
        }
        real next = real(0.5) * (low + high);
        if (abs(value) < (high - low) * abs(slope)) {
            real newton = t - value / slope;
            next = newton > low && newton < high ? newton : next;
        }
        t = next;
    }
    return t;
}

Root first_root_bracketed(Quartic f, Search search) {
    Root root;
    root.found = false;
    root.t = search.low;
    real s = sqrt(max(real(0), -f.c) / real(6));
    real side = quartic_value(f, search.low) < real(0) ? real(-1) : real(1);
    for (int region = 0; region < 3; ++region) {
        Search piece = search;
        piece.low = region == 0 ? search.low : max(search.low, region == 1 ? -s : s);
        piece.high = region == 2 ? search.high : min(search.high, region == 0 ? -s : s);
        if (piece.high <= piece.low) {
            continue;
        }
        real end = piece.high;
        real slope_side = quartic_slope(f, piece.low) < real(0) ? real(-1) : real(1);
        if (slope_side * quartic_slope(f, piece.high) < real(0)) {
            // The error of a turning point counts twice less than that of a root.
            piece.tolerance = real(0.1) * search.tolerance;
            piece.high = bracketed_root(f, true, slope_side, piece);
            piece.tolerance = search.tolerance;
        }
        for (int half_piece = 0; half_piece < 2; ++half_piece) {
            if (side * quartic_value(f, piece.high) < real(0)) {
                root.t = bracketed_root(f, false, side, piece);
                root.found = true;
                return root;
            }
            piece.low = piece.high;
            piece.high = end;
        }
    }
    return root;
}
