// First root of a quartic or cubic by intervals in which it is monotone, after Yuksel 2022,
// "High-performance polynomial root finding for graphics", Proc. ACM CGIT 5(3).
//
// The roots of the derivative cut the search into monotone pieces, and a piece whose ends differ in
// sign holds one root: Newton from the middle, kept in a bracket that halves where Newton would
// leave it. The derivative's own roots are found alike between the inflections, where it is
// monotone.

// Newton needs 4 to 8 steps; the rest is for the halvings at double roots.
const int bracketed_steps_max = 48;

// The root of side * f, or with slopes of side * f', between a place where it is not negative and
// one where it is, whichever comes first.
Root bracketed_root(Polynomial f, bool slopes, real side, Search search) {
    real low = search.low;
    real high = search.high;
    Root root = root_at(real(0.5) * (low + high), 0);
    for (int i = 0; i < bracketed_steps_max; ++i) {
        root.steps = i + 1;
        real value = side * (slopes ? slope_at(f, root.t) : value_at(f, root.t));
        real slope = side * (slopes ? bend_at(f, root.t) : slope_at(f, root.t));
        low = value >= real(0) ? root.t : low;
        high = value >= real(0) ? high : root.t;
        // Only a step of Newton tells how near the root is, a halving does not.
        if (abs(value) < search.tolerance * abs(slope)) {
            root.t = clamp(root.t - value / slope, low, high);
            return root;
        }
        real next = real(0.5) * (low + high);
        if (abs(value) < (high - low) * abs(slope)) {
            real newton = root.t - value / slope;
            next = newton > low && newton < high ? newton : next;
        }
        root.t = next;
    }
    return root;
}

Root first_root_bracketed(Polynomial f, Search search) {
    Roots2 bends = inflections(f);
    real side = value_at(f, search.low) < real(0) ? real(-1) : real(1);
    int steps = 0;
    for (int region = 0; region < 3; ++region) {
        Search piece = search;
        piece.low =
            region == 0 ? search.low : max(search.low, region == 1 ? bends.low : bends.high);
        piece.high =
            region == 2 ? search.high : min(search.high, region == 0 ? bends.low : bends.high);
        if (piece.high <= piece.low) {
            continue;
        }
        real end = piece.high;
        real slope_side = slope_at(f, piece.low) < real(0) ? real(-1) : real(1);
        if (slope_side * slope_at(f, piece.high) < real(0)) {
            // The error of a turning point counts twice less than that of a root.
            piece.tolerance = real(0.1) * search.tolerance;
            Root turning = bracketed_root(f, true, slope_side, piece);
            piece.high = turning.t;
            piece.tolerance = search.tolerance;
            steps = steps + turning.steps;
        }
        for (int half_piece = 0; half_piece < 2; ++half_piece) {
            if (side * value_at(f, piece.high) < real(0)) {
                Root root = bracketed_root(f, false, side, piece);
                root.steps = root.steps + steps;
                return root;
            }
            piece.low = piece.high;
            piece.high = end;
        }
    }
    return no_root(search.low, steps);
}
