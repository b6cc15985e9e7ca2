// First root of a depressed quartic by Sturm's sequence and halving: de Toledo, Levy, Paul 2007,
// "Iterative methods for visualization of implicit surfaces on GPU", sections 3 and 4.1.
//
// How often the signs of f, f' and the negated remainders change falls by the number of roots from
// one place to the next. The remainders take products of many coefficients: in float they overflow,
// as the paper says, unless t is measured in the size of the curve, and they still lose digits.

// Of the interval, 18 halvings leave a 262144th.
const int sturm_halvings = 18;

// Remainders times squares, so that nothing is divided.
struct Sturm {
    Quartic f;
    real a;  // a t^2 + b t + c: the first remainder
    real b;
    real c;
    real slope;  // slope t + offset: the second
    real offset;
    real last;  // the third
};

Sturm sturm_sequence(Quartic f) {
    Sturm chain;
    chain.f = f;
    // Without its square term the first remainder is a line, and the next division another: a term
    // that rounding could have left avoids that.
    chain.a = f.c == real(0) ? rounding() : real(-0.5) * f.c;
    chain.b = real(-0.75) * f.d;
    chain.c = -f.e;
    real a = chain.a;
    real b = chain.b;
    real c = chain.c;
    chain.slope = real(4) * (a * c - b * b) - real(2) * f.c * a * a;
    chain.offset = -(f.d * a * a + real(4) * b * c);
    chain.last = -(a * chain.offset * chain.offset - b * chain.offset * chain.slope +
                   c * chain.slope * chain.slope);
    return chain;
}

int sign_change(real before, real after) {
    return (before < real(0)) != (after < real(0)) ? 1 : 0;
}

int sign_changes(Sturm chain, real t) {
    real value = quartic_value(chain.f, t);
    real slope = quartic_slope(chain.f, t);
    real first = (chain.a * t + chain.b) * t + chain.c;
    real second = chain.slope * t + chain.offset;
    return sign_change(value, slope) + sign_change(slope, first) + sign_change(first, second) +
           sign_change(second, chain.last);
}

Root first_root_sturm(Quartic f, Search search) {
    Root root;
    root.found = false;
    root.t = search.low;
    if (search.high <= search.low) {
        return root;
    }
    Sturm chain = sturm_sequence(scaled_quartic(f, search.scale));
    real low = search.low / search.scale;
    real high = search.high / search.scale;
    int before = sign_changes(chain, low);
    if (before <= sign_changes(chain, high)) {
        return root;
    }
    for (int i = 0; i < sturm_halvings; ++i) {
        real middle = real(0.5) * (low + high);
        bool passed = before > sign_changes(chain, middle);
        high = passed ? middle : high;
        low = passed ? low : middle;
    }
    root.found = true;
    root.t = clamp(real(0.5) * (low + high) * search.scale, search.low, search.high);
    return root;
}
