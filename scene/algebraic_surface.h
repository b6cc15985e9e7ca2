// Polynomials as the records of cubic and quartic surfaces, and back.
#pragma once

#include "scene/add_shape.h"
#include "scene/polynomial3.h"

namespace quartic {

// The surface where the polynomial vanishes, in the cube [-1, 1]^3 times half_size; the
// polynomial's coordinates are measured in half_size. Its degree must not exceed the record's.
f64::CubicSurface cubic_surface(const Polynomial3& polynomial, double half_size);
f64::QuarticSurface quartic_surface(const Polynomial3& polynomial, double half_size);

Polynomial3 polynomial_of(const f64::CubicSurface& surface);
Polynomial3 polynomial_of(const f64::QuarticSurface& surface);

// As a cubic surface if the degree allows it.
Added add_surface(Scene& scene, const Polynomial3& polynomial, double half_size, const Part& part);

}  // namespace quartic
