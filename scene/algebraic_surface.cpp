// Records are plain scalars in the order of the terms, so that they can be copied.
#include "scene/algebraic_surface.h"

#include <cstring>

namespace quartic {
namespace {

template <class Shape, std::size_t count>
Shape record_of(const std::array<double, count>& terms, double half_size) {
    Shape shape{};
    static_assert(sizeof(Shape) > sizeof(terms));
    std::memcpy(&shape, terms.data(), sizeof(terms));
    shape.half_size = half_size;
    return shape;
}

template <std::size_t count, class Shape>
std::array<double, count> terms_of(const Shape& shape) {
    std::array<double, count> terms;
    std::memcpy(terms.data(), &shape, sizeof(terms));
    return terms;
}

}  // namespace

f64::CubicSurface cubic_surface(const Polynomial3& polynomial, double half_size) {
    return record_of<f64::CubicSurface>(polynomial.cubic_terms(), half_size);
}

f64::QuarticSurface quartic_surface(const Polynomial3& polynomial, double half_size) {
    return record_of<f64::QuarticSurface>(polynomial.terms(), half_size);
}

Polynomial3 polynomial_of(const f64::CubicSurface& surface) {
    return Polynomial3::from_cubic(terms_of<20>(surface));
}

Polynomial3 polynomial_of(const f64::QuarticSurface& surface) {
    return Polynomial3(terms_of<Polynomial3::term_count>(surface));
}

Added add_surface(Scene& scene, const Polynomial3& polynomial, double half_size, const Part& part) {
    return polynomial.degree() <= 3
               ? add_shape(scene, cubic_surface(polynomial, half_size), part)
               : add_shape(scene, quartic_surface(polynomial, half_size), part);
}

}  // namespace quartic
