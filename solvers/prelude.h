// Included inside a class template over Real: the C++ side of prelude.glsl.
using real = Real;
using vec2 = glm::vec<2, Real>;
using vec3 = glm::vec<3, Real>;
using vec4 = glm::vec<4, Real>;
real pi() const { return real(3.14159265358979323846L); }
