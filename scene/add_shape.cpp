// Adds shapes to a scene; those with a zero dimension become discs, flat boxes, simpler solids or
// nothing.
#include "scene/add_shape.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace quartic {
namespace {

constexpr double full_turn = 2.0 * std::numbers::pi;
// Files hold floats: what their rounding makes of a full turn or of R = r is meant as such.
constexpr double rounding = 1e-6;

constexpr std::string_view zero_radius = "a radius of zero: nothing to see";
constexpr std::string_view zero_arc = "an arc of zero: nothing to see";
constexpr std::string_view zero_lengths = "two lengths are zero: nothing to see";
constexpr std::string_view became_disc = "a height of zero: drawn as a disc";
constexpr std::string_view became_bigger_disc =
    "a height of zero: drawn as the bigger circle's disc, which the smaller one overhangs";
constexpr std::string_view became_level_disc =
    "a height of zero between sheared ends: drawn as a level disc";
constexpr std::string_view became_flat_box = "a thickness of zero: drawn as a flat box";
constexpr std::string_view became_thin = "a thickness of zero: drawn as a thin plate";

template <class Shape>
Added add_sound(Scene& scene, const Shape& shape, const Part& part, std::string_view reason = {}) {
    const std::string_view fault = find_fault(shape);
    if (!fault.empty()) {
        return {false, fault};
    }
    add_part(scene, shape, part);
    return {true, reason};
}

// The part moved by a vector of its own frame.
Part moved(Part part, const glm::dvec3& local) {
    part.placement.position += part.placement.rotation * local;
    return part;
}

// Discs have no ends to hide; a disc between neighbours that hide both of them is not seen at all,
// which nobody minds.
Added add_disc(Scene& scene, double radius, Part part, std::string_view reason) {
    part.open_ends = 0;
    part.smooth_ends = 0;
    return add_sound(scene, f64::Disk{radius, 0.0, 0.0, 0.0}, part, reason);
}

// The disc of a snout of zero height: of the bigger circle, where it stands.
Added add_flat_snout(Scene& scene, const f64::Snout& snout, const Part& part) {
    f64::Snout upright = snout;
    upright.height = 1.0;
    upright.offset = 0.0;
    upright.bottom_slope_x = upright.bottom_slope_y = 0.0;
    upright.top_slope_x = upright.top_slope_y = 0.0;
    const std::string_view fault = find_fault(upright);
    if (!fault.empty() || !std::isfinite(snout.offset)) {
        return {false, fault.empty() ? "a parameter is not finite" : fault};
    }
    const double bigger = std::max(snout.bottom_radius, snout.top_radius);
    const double smaller = std::min(snout.bottom_radius, snout.top_radius);
    const bool sheared = snout.bottom_slope_x != 0.0 || snout.bottom_slope_y != 0.0 ||
                         snout.top_slope_x != 0.0 || snout.top_slope_y != 0.0;
    const bool overhangs = std::abs(snout.offset) + smaller > bigger * (1.0 + rounding);
    const double side = snout.bottom_radius >= snout.top_radius ? -0.5 : 0.5;
    const std::string_view reason =
        sheared ? became_level_disc : (overhangs ? became_bigger_disc : became_disc);
    return add_disc(scene, bigger, moved(part, {side * snout.offset, 0.0, 0.0}), reason);
}

// A pyramid of zero height: the bigger rectangle, where it stands.
Added add_flat_pyramid(Scene& scene, const f64::Pyramid& pyramid, const Part& part) {
    f64::Pyramid upright = pyramid;
    upright.height = 1.0;
    const std::string_view fault = find_fault(upright);
    if (!fault.empty()) {
        return {false, fault};
    }
    const bool bottom = pyramid.bottom_x * pyramid.bottom_y >= pyramid.top_x * pyramid.top_y;
    const double side = bottom ? -0.5 : 0.5;
    const f64::Box box{bottom ? pyramid.bottom_x : pyramid.top_x,
                       bottom ? pyramid.bottom_y : pyramid.top_y, 0.0, 0.0};
    const glm::dvec3 centre{side * pyramid.offset_x, side * pyramid.offset_y, 0.0};
    return add_sound(scene, box, moved(part, centre), became_flat_box);
}

// A pyramid that is a plate standing on its edge: a flat box if it is a rectangle, else a plate of
// little thickness.
Added add_plate(Scene& scene, f64::Pyramid pyramid, const Part& part) {
    const bool flat_x = pyramid.bottom_x + pyramid.top_x == 0.0;
    const double width = flat_x ? pyramid.bottom_y : pyramid.bottom_x;
    const double top_width = flat_x ? pyramid.top_y : pyramid.top_x;
    if (width == top_width && pyramid.offset_x == 0.0 && pyramid.offset_y == 0.0) {
        const f64::Box box{flat_x ? 0.0 : width, flat_x ? width : 0.0, pyramid.height, 0.0};
        return add_sound(scene, box, part, became_flat_box);
    }
    // Thick enough for float32, thin enough for the eye.
    const double thickness = 1e-4 * std::max({width, top_width, pyramid.height});
    (flat_x ? pyramid.bottom_x : pyramid.bottom_y) = thickness;
    (flat_x ? pyramid.top_x : pyramid.top_y) = thickness;
    return add_sound(scene, pyramid, part, became_thin);
}

}  // namespace

Added add_shape(Scene& scene, const f64::Sphere& shape, const Part& part) {
    if (shape.radius == 0.0) {
        return {false, zero_radius};
    }
    return add_sound(scene, shape, part);
}

Added add_shape(Scene& scene, const f64::Dish& shape, const Part& part) {
    if (shape.radius == 0.0) {
        return {false, zero_radius};
    }
    if (shape.height == 0.0) {
        return add_disc(scene, shape.radius, part, became_disc);
    }
    return add_sound(scene, shape, part);
}

Added add_shape(Scene& scene, const f64::Cylinder& shape, const Part& part) {
    if (shape.radius == 0.0) {
        return {false, zero_radius};
    }
    if (shape.height == 0.0) {
        return add_disc(scene, shape.radius, part, became_disc);
    }
    return add_sound(scene, shape, part);
}

Added add_shape(Scene& scene, const f64::Cone& shape, const Part& part) {
    if (shape.bottom_radius == 0.0 && shape.top_radius == 0.0) {
        return {false, zero_radius};
    }
    if (shape.height == 0.0) {
        const f64::Snout snout{shape.bottom_radius, shape.top_radius, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
        return add_flat_snout(scene, snout, part);
    }
    if (shape.bottom_radius == shape.top_radius) {
        return add_sound(scene, f64::Cylinder{shape.bottom_radius, shape.height, 0.0, 0.0}, part);
    }
    return add_sound(scene, shape, part);
}

Added add_shape(Scene& scene, const f64::Snout& shape, const Part& part) {
    if (shape.bottom_radius == 0.0 && shape.top_radius == 0.0) {
        return {false, zero_radius};
    }
    if (shape.height == 0.0) {
        return add_flat_snout(scene, shape, part);
    }
    const bool simple = shape.offset == 0.0 && shape.bottom_slope_x == 0.0 &&
                        shape.bottom_slope_y == 0.0 && shape.top_slope_x == 0.0 &&
                        shape.top_slope_y == 0.0;
    if (simple) {
        const f64::Cone cone{shape.bottom_radius, shape.top_radius, shape.height, 0.0};
        return add_shape(scene, cone, part);
    }
    return add_sound(scene, shape, part);
}

Added add_shape(Scene& scene, const f64::Torus& shape, const Part& part) {
    if (shape.radius == 0.0) {
        return {false, zero_radius};
    }
    if (shape.arc == 0.0) {
        return {false, zero_arc};
    }
    f64::Torus torus = shape;
    if (std::abs(torus.arc - full_turn) <= rounding) {
        torus.arc = full_turn;
    }
    if (torus.bend_radius < torus.radius && torus.bend_radius >= torus.radius * (1.0 - rounding)) {
        torus.bend_radius = torus.radius;
    }
    return add_sound(scene, torus, part);
}

Added add_shape(Scene& scene, const f64::RectangularTorus& shape, const Part& part) {
    if (shape.outer_radius == 0.0) {
        return {false, zero_radius};
    }
    if (shape.arc == 0.0) {
        return {false, zero_arc};
    }
    f64::RectangularTorus torus = shape;
    if (std::abs(torus.arc - full_turn) <= rounding) {
        torus.arc = full_turn;
    }
    return add_sound(scene, torus, part);
}

Added add_shape(Scene& scene, const f64::Box& shape, const Part& part) {
    const Added added = add_sound(scene, shape, part);
    const bool flat = shape.length_x == 0.0 || shape.length_y == 0.0 || shape.length_z == 0.0;
    return added.drawn && flat ? Added{true, became_flat_box} : added;
}

Added add_shape(Scene& scene, const f64::Pyramid& shape, const Part& part) {
    const bool flat_x = shape.bottom_x == 0.0 && shape.top_x == 0.0;
    const bool flat_y = shape.bottom_y == 0.0 && shape.top_y == 0.0;
    if (flat_x + flat_y + (shape.height == 0.0) > 1) {
        return {false, zero_lengths};
    }
    if (shape.height == 0.0) {
        return add_flat_pyramid(scene, shape, part);
    }
    return flat_x || flat_y ? add_plate(scene, shape, part) : add_sound(scene, shape, part);
}

Added add_shape(Scene& scene, const f64::Disk& shape, const Part& part) {
    if (shape.radius == 0.0) {
        return {false, zero_radius};
    }
    return add_sound(scene, shape, part);
}

Added add_shape(Scene& scene, const f64::CubicSurface& shape, const Part& part) {
    return add_sound(scene, shape, part);
}

Added add_shape(Scene& scene, const f64::QuarticSurface& shape, const Part& part) {
    return add_sound(scene, shape, part);
}

}  // namespace quartic
