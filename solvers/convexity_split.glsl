// First root of a quartic or cubic in an interval, by Newton steps that convexity keeps monotone.
//
// Two inflections cut the line into at most three regions. With g = f or -f such that g > 0 at the
// start: in a convex region Newton from the left end descends monotonically to the first root, and
// meets g' >= 0 if there is none; in a concave region a root exists exactly if g < 0 at the right
// end, and Newton from there is monotone. So no root is jumped, whatever the interval.
//
// All regions are looked at before the one loop, without branches: processors that work in step pay
// for every branch, and for every loop at least once.

// Convergence is quadratic: 14 steps were the most ever seen, the bound is for rounding at double
// roots.
const int newton_steps_max = 32;

// Where Newton starts in a region that holds a root, or may do so.
struct Start {
    bool exists;
    bool certain;  // the sign changes; else g dips, and may stay above 0
    real t;
    real furthest;  // the region's end: beyond it a dip was none
};

// The region between the ends, with g and its slope there.
Start start_in(bool convex, vec2 ends, real value_right, vec2 slopes) {
    Start start;
    start.certain = value_right < real(0) && ends.y > ends.x;
    start.exists = start.certain || (convex && slopes.x < real(0) && slopes.y > real(0));
    start.t = convex ? ends.x : ends.y;
    start.furthest = ends.y;
    return start;
}

Start earlier_start(Start first, Start second) {
    Start start;
    start.exists = first.exists || second.exists;
    start.certain = first.exists ? first.certain : second.certain;
    start.t = first.exists ? first.t : second.t;
    start.furthest = first.exists ? first.furthest : second.furthest;
    return start;
}

Root first_root_convexity_split(Polynomial f, Search search) {
    real low = search.low;
    real high = search.high;
    Roots2 bends = inflections(f);
    real left = clamp(bends.low, low, max(low, high));
    real right = clamp(bends.high, low, max(low, high));
    real side = search.starts_above || value_at(f, low) >= real(0) ? real(1) : real(-1);
    bool outside = is_convex_outside(f) == (side > real(0));
    vec4 slopes =
        side * vec4(slope_at(f, low), slope_at(f, left), slope_at(f, right), slope_at(f, high));
    Start first =
        start_in(outside, vec2(low, left), side * value_at(f, left), vec2(slopes.x, slopes.y));
    Start middle =
        start_in(!outside, vec2(left, right), side * value_at(f, right), vec2(slopes.y, slopes.z));
    Start last =
        start_in(outside, vec2(right, high), side * value_at(f, high), vec2(slopes.z, slopes.w));
    // After a dip that was none comes at most one more region: if that dips too, it is the last.
    Start later = earlier_start(middle, last);
    Start now = earlier_start(first, later);
    Start next = later;
    if (!first.exists) {
        next = last;
        next.exists = middle.exists && last.exists;
    }
    bool lost = !now.exists || high <= low;
    real t = now.t;
    int steps = 0;
    for (int i = 0; i < newton_steps_max; ++i) {
        steps = i + 1;
        real slope = slope_at(f, t);
        // A crossing without a slope is where rounding put it.
        real change = slope == real(0) ? real(0) : value_at(f, t) / slope;
        bool passed = !now.certain && (side * slope >= real(0) || t - change > now.furthest);
        lost = lost || (passed && !next.exists);
        t = passed ? next.t : t - change;
        now.certain = passed ? next.certain : now.certain;
        now.furthest = passed ? next.furthest : now.furthest;
        next.exists = next.exists && !passed;
        if (lost || (!passed && abs(change) < search.tolerance)) {
            break;
        }
    }
    Root root;
    root.found = !lost;
    root.t = clamp(t, low, max(low, high));
    root.steps = steps;
    return root;
}
