// What a shape is called in RVM files, and its parameters there.
#pragma once

#include "primitives/shape.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace quartic {

// The kind number and the parameters of a PRIM chunk, in millimetres and radians.
struct RvmRecordOfShape {
    std::uint32_t kind = 0;
    std::size_t count = 0;
    std::array<double, 9> values{};
};

constexpr std::uint32_t rvm_line_kind = 10;
constexpr std::uint32_t rvm_facet_group_kind = 11;
constexpr double rvm_local_per_metre = 1000.0;

#define SHAPE(id, Type, name) RvmRecordOfShape rvm_record(const f64::Type& shape);
#include "primitives/catalog.h"
#undef SHAPE

// A rod along local z, as the line layer has them.
RvmRecordOfShape rvm_line_record(const f64::Cylinder& rod);

}  // namespace quartic
