// First root of a quartic or cubic in an interval, by Newton steps that convexity keeps monotone.
//
// Two inflections cut the line into at most three regions. With g = f or -f such that g > 0 at the
// start: in a convex region Newton from the left end descends monotonically to the first root, and
// meets g' >= 0 if there is none; in a concave region a root exists exactly if g < 0 at the right
// end, and Newton from there is monotone. So no root is jumped, whatever the interval.
//
// All regions are looked at before the one loop: on processors that work in step, three loops cost
// three times one.

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

Start start_in(bool convex, vec2 ends, vec2 values, vec2 slopes) {
    Start start;
    start.certain = values.y < real(0);
    bool dips = convex && slopes.x < real(0) && slopes.y > real(0);
    start.exists = ends.y > ends.x && (start.certain || dips);
    start.t = convex ? ends.x : ends.y;
    start.furthest = ends.y;
    return start;
}

Root first_root_convexity_split(Polynomial f, Search search) {
    if (search.high <= search.low) {
        return no_root(search.low, 0);
    }
    real low = search.low;
    real high = search.high;
    Roots2 bends = inflections(f);
    real left = clamp(bends.low, low, high);
    real right = clamp(bends.high, low, high);
    real value_low = value_at(f, low);
    real side = value_low < real(0) ? real(-1) : real(1);
    bool outside = is_convex_outside(f) == (side > real(0));
    vec4 values = side * vec4(value_low, value_at(f, left), value_at(f, right), value_at(f, high));
    vec4 slopes =
        side * vec4(slope_at(f, low), slope_at(f, left), slope_at(f, right), slope_at(f, high));

    Start now =
        start_in(outside, vec2(low, left), vec2(values.x, values.y), vec2(slopes.x, slopes.y));
    Start next =
        start_in(!outside, vec2(left, right), vec2(values.y, values.z), vec2(slopes.y, slopes.z));
    Start last =
        start_in(outside, vec2(right, high), vec2(values.z, values.w), vec2(slopes.z, slopes.w));
    if (!next.exists) {
        next = last;
        last.exists = false;
    }
    if (!now.exists) {
        now = next;
        next = last;
    }
    if (!now.exists) {
        return no_root(low, 0);
    }
    // After a dip that was none comes at most one more region: if that dips too, it is the last.
    Root root = no_root(now.t, 0);
    for (int i = 0; i < newton_steps_max; ++i) {
        root.steps = i + 1;
        real slope = slope_at(f, root.t);
        real change = slope == real(0) ? real(0) : value_at(f, root.t) / slope;
        bool passed = !now.certain && (side * slope >= real(0) || root.t - change > now.furthest);
        if (passed && !next.exists) {
            return root;
        }
        root.t = passed ? next.t : root.t - change;
        if (passed) {
            now = next;
            next.exists = false;
        } else if (abs(change) < search.tolerance) {
            break;
        }
    }
    root.found = true;
    root.t = clamp(root.t, low, high);
    return root;
}
