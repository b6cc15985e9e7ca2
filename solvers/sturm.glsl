// First root of a quartic or cubic by Sturm's sequence and halving: de Toledo, Levy, Paul 2007,
// "Iterative methods for visualization of implicit surfaces on GPU", sections 3 and 4.1.
//
// How often the signs of f, f' and the negated remainders change falls by the number of roots from
// one place to the next. The remainders take products of many coefficients: in float they overflow,
// as the paper says, unless t is measured in the size of the curve, and they still lose digits.

// Of the interval, 20 halvings leave a millionth.
const int sturm_halvings = 20;

// Remainders times squares, so that little is divided.
struct Sturm {
    Polynomial f;
    real a;  // a t^2 + b t + c: the first remainder
    real b;
    real c;
    real slope;  // slope t + offset: the second
    real offset;
    real last;  // the third
};

Sturm sturm_sequence(Polynomial f) {
    Sturm chain;
    chain.f = f;
    if (f.a4 == real(0)) {
        // Of a cubic the first remainder is a line, and the second the last.
        real third = f.a2 / (real(9) * (f.a3 == real(0) ? rounding() : f.a3));
        chain.a = real(0);
        chain.b = real(2) * f.a2 * third - real(2) / real(3) * f.a1;
        chain.c = f.a1 * third - f.a0;
        chain.slope = real(0);
        chain.offset = -((real(3) * f.a3 * chain.c - real(2) * f.a2 * chain.b) * chain.c +
                         f.a1 * chain.b * chain.b);
        chain.last = chain.offset;
        return chain;
    }
    real quarter = f.a3 / (real(16) * f.a4);
    real a = real(3) * f.a3 * quarter - real(0.5) * f.a2;
    // Without its square term the first remainder is a line, and the next division another: a term
    // that rounding could have left avoids that.
    a = a == real(0) ? rounding() : a;
    real b = real(2) * f.a2 * quarter - real(0.75) * f.a1;
    real c = f.a1 * quarter - f.a0;
    real quotient = real(3) * f.a3 * a - real(4) * f.a4 * b;
    chain.a = a;
    chain.b = b;
    chain.c = c;
    chain.slope = real(4) * f.a4 * c * a + b * quotient - real(2) * f.a2 * a * a;
    chain.offset = c * quotient - f.a1 * a * a;
    chain.last = -(a * chain.offset * chain.offset - b * chain.offset * chain.slope +
                   c * chain.slope * chain.slope);
    return chain;
}

int sign_change(real before, real after) {
    return (before < real(0)) != (after < real(0)) ? 1 : 0;
}

int sign_changes(Sturm chain, real t) {
    real value = value_at(chain.f, t);
    real slope = slope_at(chain.f, t);
    real first = (chain.a * t + chain.b) * t + chain.c;
    real second = chain.slope * t + chain.offset;
    return sign_change(value, slope) + sign_change(slope, first) + sign_change(first, second) +
           sign_change(second, chain.last);
}

// With adaptive, halves until what is left is shorter than the search's resolution: the paper's
// level of detail, fewer halvings for what is far away.
Root first_root_sturm(Polynomial f, Search search, bool adaptive) {
    if (search.high <= search.low) {
        return no_root(search.low, 0);
    }
    Sturm chain = sturm_sequence(scaled(f, search.scale));
    real low = search.low / search.scale;
    real high = search.high / search.scale;
    real enough = adaptive ? search.resolution / search.scale : real(0);
    int before = sign_changes(chain, low);
    if (before <= sign_changes(chain, high)) {
        return no_root(search.low, 0);
    }
    Root root = root_at(low, 0);
    for (int i = 0; i < sturm_halvings; ++i) {
        if (adaptive && high - low <= enough) {
            break;
        }
        root.steps = i + 1;
        real middle = real(0.5) * (low + high);
        bool passed = before > sign_changes(chain, middle);
        high = passed ? middle : high;
        low = passed ? low : middle;
    }
    root.t = clamp(real(0.5) * (low + high) * search.scale, search.low, search.high);
    return root;
}
