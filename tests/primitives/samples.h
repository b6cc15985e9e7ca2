// Shapes of every type with ordinary and awkward parameters, for the suites over the whole
// catalogue.
#pragma once

#include "primitives/shape.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <array>
#include <cstring>
#include <tuple>
#include <type_traits>
#include <vector>

namespace quartic::test {

template <class Shape>
std::vector<Shape> samples();

#define SHAPE(id, Type, name) \
    template <>               \
    std::vector<f64::Type> samples<f64::Type>();
#include "primitives/catalog.h"
#undef SHAPE

template <class Tuple>
struct AsTypes;
template <class... Shapes>
struct AsTypes<std::tuple<Shapes...>> {
    using Types = ::testing::Types<Shapes...>;
};

template <class Shape, bool implicit>
using TupleIf = std::conditional_t<Implicit<Shape> == implicit, std::tuple<Shape>, std::tuple<>>;

template <bool implicit>
using ShapesIf = decltype(std::tuple_cat(
#define SHAPE(id, Type, name) TupleIf<f64::Type, implicit>(),
#include "primitives/catalog.h"
#undef SHAPE
    std::tuple<>()));

// The shapes of the catalogue as GoogleTest's lists of types: those with faces that point() walks
// over, and those that are given by where value() vanishes.
using AllShapes = AsTypes<ShapesIf<false>>::Types;
using ImplicitShapes = AsTypes<ShapesIf<true>>::Types;

inline f64::Ray ray_from(const glm::dvec3& origin, const glm::dvec3& direction) {
    f64::Ray ray;
    ray.origin = origin;
    ray.direction = direction;
    ray.first = 0.0;
    ray.pixel = 0.0;
    return ray;
}

// The diagonal of the bounds: the length that tolerances refer to.
template <class Shape>
double size_of(const Shape& shape) {
    const f64::Bounds box = f64().bounds(shape);
    return glm::length(box.high - box.low);
}

// A solid of no thickness: it has no inside.
template <class Shape>
bool is_flat(const Shape& shape) {
    const f64::Bounds box = f64().bounds(shape);
    const glm::dvec3 extent = box.high - box.low;
    return extent.x == 0.0 || extent.y == 0.0 || extent.z == 0.0;
}

// The unit normal du x dv of a face by central differences; (0, 0, 0) where the face has no area.
template <class Shape>
glm::dvec3 patch_normal(const Shape& shape, int face, double u, double v) {
    const double h = 1e-6;
    f64 kernel;
    const glm::dvec3 du =
        kernel.point(shape, face, {u + h, v}) - kernel.point(shape, face, {u - h, v});
    const glm::dvec3 dv =
        kernel.point(shape, face, {u, v + h}) - kernel.point(shape, face, {u, v - h});
    const glm::dvec3 normal = glm::cross(du, dv);
    const double length = glm::length(normal);
    return length > 1e-7 * (glm::dot(du, du) + glm::dot(dv, dv)) ? normal / length
                                                                 : glm::dvec3(0.0);
}

// The same record in the other real type: records are nothing but scalars.
template <class Target, class From, class To, class Source>
Target convert_record(const Source& source) {
    constexpr std::size_t count = sizeof(Source) / sizeof(From);
    static_assert(sizeof(Target) == count * sizeof(To));
    std::array<From, count> from;
    std::memcpy(from.data(), &source, sizeof(Source));
    std::array<To, count> to;
    for (std::size_t i = 0; i < count; ++i) {
        to[i] = static_cast<To>(from[i]);
    }
    Target target;
    std::memcpy(&target, to.data(), sizeof(Target));
    return target;
}

#define SHAPE(id, Type, name)                                                        \
    inline f32::Type to_float(const f64::Type& shape) {                              \
        return convert_record<f32::Type, double, float>(shape);                      \
    }                                                                                \
    inline f64::Type to_double(const f32::Type& shape) {                             \
        return convert_record<f64::Type, float, double>(shape);                      \
    }                                                                                \
    inline Kernel<long double>::Type to_long_double(const f32::Type& shape) {        \
        return convert_record<Kernel<long double>::Type, float, long double>(shape); \
    }
#include "primitives/catalog.h"
#undef SHAPE

// Numbers in [0, 1) that are the same everywhere.
class Numbers {
public:
    explicit Numbers(std::uint64_t seed) : state_(seed) {}
    double next() {
        state_ = state_ * 6364136223846793005u + 1442695040888963407u;
        return static_cast<double>(state_ >> 11) * 0x1p-53;
    }
    double between(double low, double high) { return low + (high - low) * next(); }
    glm::dvec3 direction() {
        for (;;) {
            const glm::dvec3 v(between(-1, 1), between(-1, 1), between(-1, 1));
            const double length = glm::length(v);
            if (length > 0.1 && length < 1.0) {
                return v / length;
            }
        }
    }

private:
    std::uint64_t state_;
};

}  // namespace quartic::test
