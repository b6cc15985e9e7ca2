// Names and validity of the shapes in the catalogue.
#include "primitives/shape.h"

#include <cmath>
#include <initializer_list>
#include <numbers>

namespace quartic {
namespace {

constexpr ShapeRow rows[] = {
#define SHAPE(id, Type, name)                                                                  \
    {ShapeType::name,    #name, sizeof(f32::Type), Polyhedron<f64::Type>, Prepared<f64::Type>, \
     Implicit<f64::Type>},
#include "primitives/catalog.h"
#undef SHAPE
};

const ShapeRow* find_row(ShapeType type) {
    for (const ShapeRow& row : rows) {
        if (row.type == type) {
            return &row;
        }
    }
    return nullptr;
}

// Lengths above this square to more than float holds; no plant has them.
constexpr double length_max = 1e9;

std::string_view find_bad_length(std::initializer_list<double> lengths) {
    for (const double length : lengths) {
        if (!std::isfinite(length)) {
            return "a parameter is not finite";
        }
        if (length < 0.0) {
            return "a length is negative";
        }
        if (length > length_max) {
            return "a length is over 1e9 m";
        }
    }
    return {};
}

std::string_view find_zero_length(std::initializer_list<double> lengths) {
    for (const double length : lengths) {
        if (!(length > 0.0)) {
            return "a length is zero";
        }
    }
    return {};
}

std::string_view find_bad_arc(double arc) {
    if (!std::isfinite(arc) || arc <= 0.0 || arc > 2.0 * std::numbers::pi + 1e-9) {
        return "the arc is not within (0, 360] degrees";
    }
    return {};
}

std::string_view first_of(std::initializer_list<std::string_view> faults) {
    for (const std::string_view fault : faults) {
        if (!fault.empty()) {
            return fault;
        }
    }
    return {};
}

// The numbers of a record in their order.
template <class Shape>
std::span<const double> scalars(const Shape& shape) {
    return {reinterpret_cast<const double*>(&shape), sizeof(Shape) / sizeof(double)};
}

std::string_view find_bad_polynomial(std::span<const double> coefficients, double half_size) {
    bool finite = true;
    bool varies = false;
    for (std::size_t i = 0; i < coefficients.size(); ++i) {
        finite = finite && std::isfinite(coefficients[i]);
        varies = varies || (i + 1 < coefficients.size() && coefficients[i] != 0.0);
    }
    if (!finite) {
        return "a coefficient is not finite";
    }
    return varies ? first_of({find_bad_length({half_size}), find_zero_length({half_size})})
                  : "a polynomial that is constant";
}

}  // namespace

std::span<const ShapeRow> shape_table() {
    return rows;
}

std::string_view name(ShapeType type) {
    const ShapeRow* row = find_row(type);
    return row == nullptr ? "mesh" : row->name;
}

bool is_polyhedron(ShapeType type) {
    const ShapeRow* row = find_row(type);
    return row != nullptr && row->polyhedron;
}

bool is_prepared(ShapeType type) {
    const ShapeRow* row = find_row(type);
    return row != nullptr && row->prepared;
}

std::string_view find_fault(const f64::Sphere& shape) {
    return first_of({find_bad_length({shape.radius}), find_zero_length({shape.radius})});
}

std::string_view find_fault(const f64::Dish& shape) {
    return first_of({find_bad_length({shape.radius, shape.height}),
                     find_zero_length({shape.radius, shape.height})});
}

std::string_view find_fault(const f64::Cylinder& shape) {
    return first_of({find_bad_length({shape.radius, shape.height}),
                     find_zero_length({shape.radius, shape.height})});
}

std::string_view find_fault(const f64::Cone& shape) {
    return first_of({find_bad_length({shape.bottom_radius, shape.top_radius, shape.height}),
                     find_zero_length({shape.height, shape.bottom_radius + shape.top_radius})});
}

std::string_view find_fault(const f64::Snout& shape) {
    const std::string_view fault =
        first_of({find_bad_length({shape.bottom_radius, shape.top_radius, shape.height,
                                   std::abs(shape.offset), std::abs(shape.bottom_slope_x),
                                   std::abs(shape.bottom_slope_y), std::abs(shape.top_slope_x),
                                   std::abs(shape.top_slope_y)}),
                  find_zero_length({shape.height, shape.bottom_radius + shape.top_radius})});
    if (!fault.empty()) {
        return fault;
    }
    return f64().snout_is_valid(shape) ? std::string_view()
                                       : "a sheared end cuts the cone in an open curve";
}

std::string_view find_fault(const f64::Torus& shape) {
    const std::string_view fault =
        first_of({find_bad_length({shape.bend_radius, shape.radius}),
                  find_zero_length({shape.radius}), find_bad_arc(shape.arc)});
    if (!fault.empty()) {
        return fault;
    }
    return shape.bend_radius < shape.radius ? "a spindle torus: the tube crosses its own axis"
                                            : std::string_view();
}

std::string_view find_fault(const f64::RectangularTorus& shape) {
    const std::string_view fault =
        first_of({find_bad_length({shape.inner_radius, shape.outer_radius, shape.height}),
                  find_bad_arc(shape.arc)});
    if (!fault.empty()) {
        return fault;
    }
    return shape.inner_radius >= shape.outer_radius ? "the inner radius is not below the outer one"
                                                    : std::string_view();
}

std::string_view find_fault(const f64::Box& shape) {
    const std::string_view fault =
        find_bad_length({shape.length_x, shape.length_y, shape.length_z});
    if (!fault.empty()) {
        return fault;
    }
    const int zeros = (shape.length_x == 0.0) + (shape.length_y == 0.0) + (shape.length_z == 0.0);
    return zeros > 1 ? "two lengths are zero" : std::string_view();
}

std::string_view find_fault(const f64::Pyramid& shape) {
    return first_of(
        {find_bad_length({shape.bottom_x, shape.bottom_y, shape.top_x, shape.top_y, shape.height,
                          std::abs(shape.offset_x), std::abs(shape.offset_y)}),
         find_zero_length(
             {shape.height, shape.bottom_x + shape.top_x, shape.bottom_y + shape.top_y})});
}

std::string_view find_fault(const f64::Disk& shape) {
    const std::string_view fault = first_of(
        {find_bad_length({shape.radius, shape.inner_radius}), find_zero_length({shape.radius})});
    if (!fault.empty()) {
        return fault;
    }
    return shape.inner_radius >= shape.radius ? "the inner radius is not below the outer one"
                                              : std::string_view();
}

std::string_view find_fault(const f64::CubicSurface& shape) {
    return find_bad_polynomial(scalars(shape).first(20), shape.half_size);
}

std::string_view find_fault(const f64::QuarticSurface& shape) {
    return find_bad_polynomial(scalars(shape).first(35), shape.half_size);
}

}  // namespace quartic
