// The catalogue as C++ values: types, names, and storage of many shapes of each type.
#pragma once

#include "diagnostics/check.h"
#include "primitives/kernel.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace quartic {

// The id of a shape in the catalogue; mesh stands for triangles, which are no shape.
enum class ShapeType : std::uint8_t {
    mesh = 0,
#define SHAPE(id, Type, name) name = id,
#include "primitives/catalog.h"
#undef SHAPE
};

struct ShapeRow {
    ShapeType type;
    std::string_view name;
    std::size_t record_bytes;  // of the float parameters alone
    bool polyhedron;           // all faces are flat: drawn as its own triangles
    bool prepared;             // has prepare() and hit_prepared()
    bool implicit;             // given by where value() vanishes
};

// All shapes, in the order of their ids.
std::span<const ShapeRow> shape_table();
std::string_view name(ShapeType type);
bool is_polyhedron(ShapeType type);
bool is_prepared(ShapeType type);

constexpr std::size_t shape_type_count = 1
#define SHAPE(id, Type, name) +1
#include "primitives/catalog.h"
#undef SHAPE
    ;

template <class Shape>
constexpr ShapeType type_of = ShapeType::mesh;
#define SHAPE(id, Type, name)                                        \
    template <>                                                      \
    inline constexpr ShapeType type_of<f64::Type> = ShapeType::name; \
    template <>                                                      \
    inline constexpr ShapeType type_of<f32::Type> = ShapeType::name;
#include "primitives/catalog.h"
#undef SHAPE

// A shape with facet_normal() is a polyhedron.
template <class Shape>
concept Polyhedron = requires(f64 kernel, Shape shape) {
    kernel.facet_normal(shape, 0);
};

// A shape whose hit() needs numbers of the shape alone that are dear to calculate.
template <class Shape>
concept Prepared = requires(f64 kernel, Shape shape) {
    kernel.prepare(shape, 0);
};

// How many forms of ends primitives/arc.glsl has; programs count those that near the axis from here
// on.
constexpr int arc_forms = 4;

// A shape that is given by where value() vanishes has no point(face, uv).
template <class Shape>
concept Implicit = requires(f64 kernel, Shape shape) {
    kernel.value(shape, f64::vec3(0.0));
};

// Many shapes, each type in its own array.
struct ShapeStore {
#define SHAPE(id, Type, name) std::vector<f64::Type> name;
#include "primitives/catalog.h"
#undef SHAPE
};

// The array of one type.
template <class Shape>
std::vector<Shape>& array_of(ShapeStore& store) {
#define SHAPE(id, Type, name)                         \
    if constexpr (std::is_same_v<Shape, f64::Type>) { \
        return store.name;                            \
    }
#include "primitives/catalog.h"
#undef SHAPE
}

// Calls visitor(const f64::Type&) with the shape of that type at that index of its array.
template <class Visitor>
decltype(auto) visit_shape(const ShapeStore& store, ShapeType type, std::uint32_t index,
                           Visitor&& visitor) {
    switch (type) {
#define SHAPE(id, Type, name) \
    case ShapeType::name:     \
        return visitor(store.name[index]);
#include "primitives/catalog.h"
#undef SHAPE
        case ShapeType::mesh: break;
    }
    check_failed("a mesh is no shape", __FILE__, __LINE__);
}

// Why a shape cannot be drawn as it is, or empty: not finite, negative, a spindle torus, a cut that
// does not close.
#define SHAPE(id, Type, name) std::string_view find_fault(const f64::Type& shape);
#include "primitives/catalog.h"
#undef SHAPE

}  // namespace quartic
