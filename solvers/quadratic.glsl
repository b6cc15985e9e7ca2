// Real roots of a t^2 + 2 b t + c = 0 whose discriminant b^2 - a c the caller knows more exactly
// than this can.
struct Roots2 {
    real low;   // the smaller root, at least -huge
    real high;  // the larger root, at most huge
};

// Stands for infinity: GLSL does not promise arithmetic on infinities.
const real huge = real(1e18);

// The two added terms have one sign, so nothing cancels: q carries the sign of b, and the other
// root is c / q. With a = 0 one root is at infinity. The discriminant must not be negative.
Roots2 solve_quadratic(real a, real b, real c, real discriminant) {
    real root = sqrt(discriminant);
    real q = b < real(0) ? root - b : -(root + b);
    bool finite = abs(q) < huge * abs(a);
    real outer = (q < real(0)) == (a < real(0)) ? huge : -huge;
    if (finite) {
        outer = q / a;
    }
    real inner = q == real(0) ? outer : c / q;
    Roots2 roots;
    roots.low = min(outer, inner);
    roots.high = max(outer, inner);
    return roots;
}
