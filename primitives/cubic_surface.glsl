// A cubic surface: where a polynomial of degree 3 vanishes, within the cube of half_size around
// the local origin. Coordinates are measured in half_size. It is a sheet, not a solid: it has no
// caps, and its normals point to where the polynomial is positive.
struct CubicSurface {
    vec4 c[5];       // its 20 coefficients, in the order of algebraic.glsl
    real half_size;  // > 0
    real unused_0;
    real unused_1;
    real unused_2;
};

Coefficients coefficients(CubicSurface surface) {
    Coefficients c;
    for (int i = 0; i < 5; ++i) {
        c.of[4 * i] = surface.c[i].x;
        c.of[4 * i + 1] = surface.c[i].y;
        c.of[4 * i + 2] = surface.c[i].z;
        c.of[4 * i + 3] = surface.c[i].w;
    }
    return c;
}

// The polynomial and its gradient at a point of the local frame, as it is in units of half_size.
real value(CubicSurface surface, vec3 p) {
    return cubic_along(coefficients(surface), p / surface.half_size, vec3(0)).a0;
}

vec3 cubic_gradient(Coefficients c, vec3 p) {
    return vec3(cubic_along(c, p, vec3(1, 0, 0)).a1, cubic_along(c, p, vec3(0, 1, 0)).a1,
                cubic_along(c, p, vec3(0, 0, 1)).a1);
}

vec3 gradient(CubicSurface surface, vec3 p) {
    return cubic_gradient(coefficients(surface), p / surface.half_size);
}

Bounds bounds(CubicSurface surface) {
    Bounds box;
    box.low = vec3(-surface.half_size);
    box.high = vec3(surface.half_size);
    return box;
}

int end_count(CubicSurface surface) {
    return 0;
}

End end(CubicSurface surface, int index) {
    return no_end();
}

vec3 farthest(CubicSurface surface, vec3 n) {
    return farthest_of_box(bounds(surface), n);
}

bool suits_outline(CubicSurface surface) {
    return true;
}

int hull_rings(CubicSurface surface) {
    return 2;
}

vec3 hull_point(CubicSurface surface, int ring, int corner, real margin) {
    real reach = surface.half_size + margin;
    vec2 xy = rectangle_corner(vec2(reach), corner);
    return vec3(xy.x, xy.y, ring == 0 ? -reach : reach);
}

Hit hit(CubicSurface surface, Ray ray, int open_ends, int solver) {
    Coefficients c = coefficients(surface);
    AlgebraicLine line = in_cube(ray, surface.half_size);
    Root root = first_root(cubic_along(c, line.p, line.v), line.search, solver);
    return hit_of(ray, line, root, cubic_gradient(c, place_of(line, root)));
}
