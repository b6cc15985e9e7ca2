// The formulas from shapes to RVM parameters (kinds and frames: docs/formats/rvm.md).
#include "exporters/rvm_records.h"

#include <cmath>
#include <initializer_list>
#include <numbers>

namespace quartic {
namespace {

constexpr double k = rvm_local_per_metre;

RvmRecordOfShape record(std::uint32_t kind, std::initializer_list<double> values) {
    RvmRecordOfShape result;
    result.kind = kind;
    for (const double value : values) {
        result.values[result.count++] = value;
    }
    return result;
}

}  // namespace

RvmRecordOfShape rvm_record(const f64::Pyramid& shape) {
    return record(1, {shape.bottom_x * k, shape.bottom_y * k, shape.top_x * k, shape.top_y * k,
                      shape.offset_x * k, shape.offset_y * k, shape.height * k});
}

RvmRecordOfShape rvm_record(const f64::Box& shape) {
    return record(2, {shape.length_x * k, shape.length_y * k, shape.length_z * k});
}

RvmRecordOfShape rvm_record(const f64::RectangularTorus& shape) {
    return record(3, {shape.inner_radius * k, shape.outer_radius * k, shape.height * k, shape.arc});
}

RvmRecordOfShape rvm_record(const f64::Torus& shape) {
    return record(4, {shape.bend_radius * k, shape.radius * k, shape.arc});
}

RvmRecordOfShape rvm_record(const f64::Dish& shape) {
    const std::uint32_t kind = f64().is_spherical(shape) ? 6 : 5;
    return record(kind, {shape.radius * k, shape.height * k});
}

RvmRecordOfShape rvm_record(const f64::Snout& shape) {
    return record(
        7, {shape.bottom_radius * k, shape.top_radius * k, shape.height * k, shape.offset * k, 0.0,
            std::atan(shape.bottom_slope_x), std::atan(shape.bottom_slope_y),
            std::atan(shape.top_slope_x), std::atan(shape.top_slope_y)});
}

RvmRecordOfShape rvm_record(const f64::Cone& shape) {
    return record(7, {shape.bottom_radius * k, shape.top_radius * k, shape.height * k, 0.0, 0.0,
                      0.0, 0.0, 0.0, 0.0});
}

RvmRecordOfShape rvm_record(const f64::Cylinder& shape) {
    return record(8, {shape.radius * k, shape.height * k});
}

// Most readers take the number as the diameter; the stored box tells the others.
RvmRecordOfShape rvm_record(const f64::Sphere& shape) {
    return record(9, {2.0 * shape.radius * k});
}

// Plants write discs as cylinders of no height; an annulus is a duct bend of no height, all around.
RvmRecordOfShape rvm_record(const f64::Disk& shape) {
    if (shape.inner_radius > 0.0) {
        return record(3, {shape.inner_radius * k, shape.radius * k, 0.0, 2.0 * std::numbers::pi});
    }
    return record(8, {shape.radius * k, 0.0});
}

RvmRecordOfShape rvm_record(const f64::CubicSurface&) {
    return record(11, {});
}

RvmRecordOfShape rvm_record(const f64::QuarticSurface&) {
    return record(11, {});
}

RvmRecordOfShape rvm_line_record(const f64::Cylinder& rod) {
    return record(rvm_line_kind, {rod.radius * k, rod.height * k});
}

}  // namespace quartic
