// Newton with bounded steps: de Toledo, Levy, Paul 2007, "Iterative methods for visualization of
// implicit surfaces on GPU", section 4.4, and a repair of it.
//
// The paper starts where the ray enters the sphere around the torus, bounds a step by 0.15 of that
// sphere's radius, and stops at a step of 0.001 or 0.00003 of the tube's radius. A step may have
// either sign: past a dip of the curve that is no root Newton turns back, oscillates about the dip
// and never comes to the root beyond. Seen from 72 degrees that loses 7 % of a torus.

const int bounded_steps_max = 32;

// The step to where the tangent vanishes, at most this far; forward where there is no slope.
real bounded_step(real value, real slope, real furthest) {
    if (value == real(0)) {
        return real(0);
    }
    if (abs(value) < furthest * abs(slope)) {
        return -value / slope;
    }
    return slope != real(0) && (value > real(0)) == (slope > real(0)) ? -furthest : furthest;
}

// With forward_only a step never turns back before the sign has changed: a dip narrower than the
// longest step may still be jumped.
Root first_root_newton(Polynomial f, Search search, bool forward_only) {
    real furthest = real(0.15) * search.scale;
    real side = forward_only && value_at(f, search.low) < real(0) ? real(-1) : real(1);
    Root root = no_root(search.low, 0);
    if (search.high <= search.low) {
        return root;
    }
    for (int i = 0; i < bounded_steps_max; ++i) {
        root.steps = i + 1;
        real value = side * value_at(f, root.t);
        real slope = side * slope_at(f, root.t);
        real change = bounded_step(value, slope, furthest);
        if (forward_only && value > real(0) && slope >= real(0)) {
            change = furthest;
        }
        root.t = root.t + change;
        bool converged = abs(change) < search.tolerance;
        real slack = converged ? search.tolerance : real(0);
        if (root.t < search.low - slack || root.t > search.high + slack) {
            return root;
        }
        if (converged) {
            root.t = clamp(root.t, search.low, search.high);
            root.found = true;
            return root;
        }
    }
    return root;
}
