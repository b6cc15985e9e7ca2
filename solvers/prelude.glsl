// The GLSL side of prelude.h: shared texts calculate in real, which is float on the GPU.
#define real float
real pi() {
    return real(3.14159265358979323846);
}
real last_step() {
    return real(0.001);
}
real rounding() {
    return real(1e-7);
}
