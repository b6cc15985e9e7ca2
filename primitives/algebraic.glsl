// Polynomials of degree 3 and 4 in x, y, z along a line, and where a ray meets their zero sets in a
// cube: what the cubic and the quartic surface share.
//
// Coefficients stand in lexicographic order, as POV-Ray writes them: x^4, x^3 y, x^3 z, x^3,
// x^2 y^2, x^2 y z, x^2 y, x^2 z^2, x^2 z, x^2, x y^3, ... z^2, z, 1; a cubic's from x^3 on. So a
// polynomial is x times one of lower degree, plus one in y and z alone: Horner's rule in three
// variables, on polynomials in the line's parameter.
struct Coefficients {
    real of[35];
};

// f times p + t v, and a constant added; powers of t rise from x to w.
vec3 next_quadratic(vec2 f, real p, real v, real constant) {
    return vec3(f.x * p + constant, f.y * p + f.x * v, f.y * v);
}

vec4 next_cubic(vec3 f, real p, real v, real constant) {
    return vec4(f.x * p + constant, f.y * p + f.x * v, f.z * p + f.y * v, f.z * v);
}

Polynomial next_quartic(vec4 f, real p, real v) {
    return polynomial(f.w * v, f.w * p + f.z * v, f.z * p + f.y * v, f.y * p + f.x * v, f.x * p);
}

// In z alone, from coefficient i on: z^2 or z^3 first.
vec3 quadratic_in_z(Coefficients c, int i, vec3 p, vec3 v) {
    return next_quadratic(vec2(c.of[i] * p.z + c.of[i + 1], c.of[i] * v.z), p.z, v.z, c.of[i + 2]);
}

vec4 cubic_in_z(Coefficients c, int i, vec3 p, vec3 v) {
    return next_cubic(quadratic_in_z(c, i, p, v), p.z, v.z, c.of[i + 3]);
}

// In y and z, from y^2, y^3 or y^4 on.
vec3 quadratic_in_yz(Coefficients c, int i, vec3 p, vec3 v) {
    vec2 plane =
        vec2(c.of[i] * p.y + c.of[i + 1] * p.z + c.of[i + 2], c.of[i] * v.y + c.of[i + 1] * v.z);
    return next_quadratic(plane, p.y, v.y, real(0)) + quadratic_in_z(c, i + 3, p, v);
}

vec4 cubic_in_yz(Coefficients c, int i, vec3 p, vec3 v) {
    return next_cubic(quadratic_in_yz(c, i, p, v), p.y, v.y, real(0)) + cubic_in_z(c, i + 6, p, v);
}

// In x, y and z, from x^2 or x^3 on.
vec3 quadratic_in_xyz(Coefficients c, int i, vec3 p, vec3 v) {
    vec2 plane = vec2(c.of[i] * p.x + c.of[i + 1] * p.y + c.of[i + 2] * p.z + c.of[i + 3],
                      c.of[i] * v.x + c.of[i + 1] * v.y + c.of[i + 2] * v.z);
    return next_quadratic(plane, p.x, v.x, real(0)) + quadratic_in_yz(c, i + 4, p, v);
}

vec4 cubic_in_xyz(Coefficients c, vec3 p, vec3 v) {
    return next_cubic(quadratic_in_xyz(c, 0, p, v), p.x, v.x, real(0)) + cubic_in_yz(c, 10, p, v);
}

// The polynomial in t of the values at p + t v.
Polynomial cubic_along(Coefficients c, vec3 p, vec3 v) {
    vec4 f = cubic_in_xyz(c, p, v);
    return polynomial(real(0), f.w, f.z, f.y, f.x);
}

Polynomial quartic_along(Coefficients c, vec3 p, vec3 v) {
    Polynomial f = next_quartic(cubic_in_xyz(c, p, v), p.x, v.x);
    Polynomial g = next_quartic(cubic_in_yz(c, 20, p, v), p.y, v.y);
    vec4 lower = cubic_in_z(c, 30, p, v);
    Polynomial h = next_quartic(lower, p.z, v.z);
    return polynomial(f.a4 + g.a4 + h.a4, f.a3 + g.a3 + h.a3, f.a2 + g.a2 + h.a2,
                      f.a1 + g.a1 + h.a1, f.a0 + g.a0 + h.a0 + c.of[34]);
}

// The part of a ray in the cube, in units of half its edge, measured from the point closest to the
// centre: there the polynomial's coefficients keep the most digits.
struct AlgebraicLine {
    vec3 p;
    vec3 v;      // unit
    real shift;  // of the ray's parameter, times its speed
    real speed;  // of the ray in these units
    Search search;
};

AlgebraicLine in_cube(Ray ray, real half_size) {
    AlgebraicLine line;
    line.speed = length(ray.direction) / half_size;
    line.v = normalize(ray.direction);
    vec3 o = ray.origin / half_size;
    line.shift = dot(o, line.v);
    line.p = o - line.shift * line.v;
    Span span = whole_line();
    span = between_planes(span, line.p.x, line.v.x, real(1));
    span = between_planes(span, line.p.y, line.v.y, real(1));
    span = between_planes(span, line.p.z, line.v.z, real(1));
    line.search.low = max(span.enter, ray.first * line.speed + line.shift);
    line.search.high = span.exit;
    line.search.tolerance = real(0.01) * last_step();
    line.search.scale = real(1);
    line.search.resolution = ray.pixel / half_size;
    line.search.starts_above = false;
    return line;
}

vec3 place_of(AlgebraicLine line, Root root) {
    return line.p + root.t * line.v;
}

Hit hit_of(Ray ray, AlgebraicLine line, Root root, vec3 gradient) {
    Hit result = miss();
    if (root.found) {
        // At a singular point every direction is as good as any.
        bool singular = dot(gradient, gradient) == real(0);
        result = hit_at(ray, (root.t - line.shift) / line.speed, singular ? -line.v : gradient);
    }
    result.steps = root.steps;
    return result;
}
