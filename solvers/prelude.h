// Included inside a class template over Real: the C++ side of prelude.glsl.
using real = Real;
using vec2 = glm::vec<2, Real>;
using vec3 = glm::vec<3, Real>;
using vec4 = glm::vec<4, Real>;
real pi() const {
    return real(3.14159265358979323846L);
}
// Newton stops at a step this small, relative to the tube: what is left is about its square. A
// float holds no more than 1e-3 gives, double and long double are the truth that it is measured
// against.
real last_step() const {
    return sizeof(Real) == sizeof(float) ? real(1e-3L) : real(1e-7L);
}
// The relative error of one operation.
real rounding() const {
    return sizeof(Real) == sizeof(float) ? real(1e-7L) : real(2e-16L);
}
