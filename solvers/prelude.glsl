// The GLSL side of prelude.h: shared texts calculate in real, which is float on the GPU.
#define real float
real pi() { return real(3.14159265358979323846); }
