// First root of a depressed quartic in an interval, by Newton steps that convexity keeps monotone.
//
// f'' = 12 t^2 + 2 c vanishes at -s and s: f is convex outside [-s, s] and concave inside. With g =
// f or -f such that g > 0 at the start: in a convex region Newton from the left end descends
// monotonically to the first root, and meets g' >= 0 if there is none; in a concave region a root
// exists exactly if g < 0 at the right end, and Newton from there is monotone. So no root is
// jumped, whatever the interval.

// Convergence is quadratic: 14 steps were the most ever seen, the bound is for rounding at double
// roots.
const int newton_steps_max = 32;

// Newton on side * f from start until a step is below the tolerance. A furthest place below huge
// says that there may be no root: a slope that is not negative means that the minimum was passed,
// and so does a step beyond that place, where another convexity, and with it another root, may
// begin.
Root newton_monotone(Quartic f, real side, real start, real furthest, real tolerance) {
    Root root;
    root.found = false;
    root.t = start;
    for (int i = 0; i < newton_steps_max; ++i) {
        real slope = side * quartic_slope(f, root.t);
        if (slope == real(0) || (slope > real(0) && furthest < huge)) {
            return root;
        }
        real change = side * quartic_value(f, root.t) / slope;
        root.t = root.t - change;
        if (root.t > furthest) {
            return root;
        }
        if (abs(change) < tolerance) {
            break;
        }
    }
    root.found = true;
    return root;
}

Root first_root_convexity_split(Quartic f, Search search) {
    real low = search.low;
    real high = search.high;
    Root root;
    root.found = false;
    root.t = low;

    real s = sqrt(max(real(0), -f.c) / real(6));
    real side = quartic_value(f, low) < real(0) ? real(-1) : real(1);

    for (int region = 0; region < 3; ++region) {
        real left = region == 0 ? low : (region == 1 ? max(low, -s) : max(low, s));
        real right = region == 0 ? min(high, -s) : (region == 1 ? min(high, s) : high);
        if (right <= left) {
            continue;
        }
        bool convex = (region == 1) == (side < real(0));
        bool crosses = side * quartic_value(f, right) < real(0);
        if (crosses) {
            return newton_monotone(f, side, convex ? left : right, huge, search.tolerance);
        }
        if (convex && side * quartic_slope(f, left) < real(0) &&
            side * quartic_slope(f, right) > real(0)) {
            root = newton_monotone(f, side, left, right, search.tolerance);
            if (root.found) {
                return root;
            }
        }
    }
    root.found = false;
    return root;
}
