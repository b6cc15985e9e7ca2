// Camera mathematics in double.
#include "scene/camera.h"

#include "scene/gpu_layout.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <numbers>

namespace quartic {
namespace {

struct NamedView {
    std::string_view name;
    glm::dvec3 direction;  // from the eye into the scene
    glm::dvec3 up;
};

constexpr NamedView named_views[] = {
    {"fit", {0.55, 0.75, -0.45}, {0, 0, 1}}, {"iso", {1, 1, -0.8164965809}, {0, 0, 1}},
    {"front", {0, 1, 0}, {0, 0, 1}},         {"back", {0, -1, 0}, {0, 0, 1}},
    {"left", {1, 0, 0}, {0, 0, 1}},          {"right", {-1, 0, 0}, {0, 0, 1}},
    {"top", {0, 0, -1}, {0, 1, 0}},          {"bottom", {0, 0, 1}, {0, 1, 0}},
};

glm::dvec3 corner_of(const Box3& box, int corner) {
    return {(corner & 1) != 0 ? box.high.x : box.low.x, (corner & 2) != 0 ? box.high.y : box.low.y,
            (corner & 4) != 0 ? box.high.z : box.low.z};
}

// Nine numbers between commas and semicolons.
std::optional<std::array<double, 9>> parse_numbers(std::string_view text) {
    std::array<double, 9> numbers{};
    const char* at = text.data();
    const char* const end = text.data() + text.size();
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const std::from_chars_result parsed = std::from_chars(at, end, numbers[i]);
        if (parsed.ec != std::errc() || !std::isfinite(numbers[i])) {
            return {};
        }
        at = parsed.ptr;
        if (i + 1 == numbers.size()) {
            break;
        }
        if (at == end || *at != (i % 3 == 2 ? ';' : ',')) {
            return {};
        }
        ++at;
    }
    return at == end ? std::optional(numbers) : std::nullopt;
}

// How far corners reach towards each side of the picture, measured where the side's plane crosses
// the middle's plane.
struct Sides {
    double right = std::numeric_limits<double>::lowest();
    double left = std::numeric_limits<double>::lowest();
    double top = std::numeric_limits<double>::lowest();
    double bottom = std::numeric_limits<double>::lowest();

    void include(const Box3& box, const glm::dvec3& middle, const View& axes, double slope_x,
                 double slope_y) {
        for (int corner = 0; corner < 8; ++corner) {
            const glm::dvec3 p = corner_of(box, corner) - middle;
            const double x = glm::dot(axes.right, p);
            const double y = glm::dot(axes.up, p);
            const double z = glm::dot(axes.back, p);
            right = std::max(right, x + slope_x * z);
            left = std::max(left, slope_x * z - x);
            top = std::max(top, y + slope_y * z);
            bottom = std::max(bottom, slope_y * z - y);
        }
    }
};

// How far to move the eye right and up, at this distance from the middle's plane, so that opposite
// sides of the picture are equally far from what it shows.
glm::dvec2 centring_shift(std::span<const Box3> boxes, const glm::dvec3& middle, const View& axes,
                          double distance) {
    constexpr int rounds = 4;  // each takes away most of what is left
    glm::dvec2 shift(0.0);
    for (int round = 0; round < rounds; ++round) {
        glm::dvec2 low(std::numeric_limits<double>::max());
        glm::dvec2 high(std::numeric_limits<double>::lowest());
        for (const Box3& box : boxes) {
            for (int corner = 0; corner < 8; ++corner) {
                const glm::dvec3 p = corner_of(box, corner) - middle;
                const double depth = std::max(distance - glm::dot(axes.back, p), 1e-9 * distance);
                const glm::dvec2 seen =
                    (glm::dvec2(glm::dot(axes.right, p), glm::dot(axes.up, p)) - shift) / depth;
                low = glm::min(low, seen);
                high = glm::max(high, seen);
            }
        }
        shift += 0.5 * distance * (low + high);
    }
    return shift;
}

}  // namespace

View make_view(const Camera& camera, PixelSize size) {
    const glm::dvec3 forward = glm::normalize(camera.target - camera.eye);
    glm::dvec3 right = glm::cross(forward, camera.up);
    if (glm::dot(right, right) < 1e-20) {
        right = glm::cross(forward,
                           std::abs(forward.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0));
    }
    right = glm::normalize(right);
    const bool perspective = camera.projection == Projection::perspective;
    const double height = perspective ? 2.0 * std::tan(0.5 * camera.fov_y) : camera.height_m;
    View view;
    view.eye = camera.eye;
    view.right = right;
    view.up = glm::cross(right, forward);
    view.back = -forward;
    view.projection = camera.projection;
    view.step = height / size.height;
    view.near_m = camera.near_m;
    view.focus_m = perspective ? 0.0 : glm::distance(camera.eye, camera.target);
    view.far_m = camera.near_m + 1.0;
    view.size = size;
    return view;
}

f64::Ray pixel_ray(const View& view, double x, double y) {
    const glm::dvec3 offset = (x - 0.5 * view.size.width) * view.step * view.right +
                              (y - 0.5 * view.size.height) * view.step * view.up;
    if (view.projection == Projection::perspective) {
        return {view.eye, offset - view.back, view.near_m, 0.0};
    }
    return {view.eye + offset, -view.back, view.near_m, 0.0};
}

glm::dvec3 project(const View& view, const glm::dvec3& world) {
    const glm::dvec3 p = world - view.eye;
    const double depth = -glm::dot(view.back, p);
    const double scale = view.step * (view.projection == Projection::perspective ? depth : 1.0);
    return {0.5 * view.size.width + glm::dot(view.right, p) / scale,
            0.5 * view.size.height + glm::dot(view.up, p) / scale, depth};
}

glm::dvec3 spread_direction(int index, int count, double turn) {
    const double golden_angle = std::numbers::pi * (3.0 - std::sqrt(5.0));
    const double z = 1.0 - (2.0 * index + 1.0) / count;
    const double radius = std::sqrt(std::max(0.0, 1.0 - z * z));
    const double angle = golden_angle * index + turn;
    return {radius * std::cos(angle), radius * std::sin(angle), z};
}

double buffer_depth(const View& view, double depth_m) {
    if (view.projection == Projection::perspective) {
        return view.near_m / depth_m;
    }
    const double height_m = view.step * view.size.height;
    gpu::Picture<double> text;
    return text.focused((depth_m - view.focus_m) / height_m) /
           text.focused((view.near_m - view.focus_m) / height_m);
}

double depth_from_buffer(const View& view, double buffer_depth) {
    if (view.projection == Projection::perspective) {
        return view.near_m / buffer_depth;
    }
    const double height_m = view.step * view.size.height;
    gpu::Picture<double> text;
    const double at_near = text.focused((view.near_m - view.focus_m) / height_m);
    return view.focus_m + height_m * text.unfocused(buffer_depth * at_near);
}

std::array<double, 2> depth_range(const Box3& box, const glm::dvec3& eye,
                                  const glm::dvec3& forward) {
    std::array<double, 2> range{std::numeric_limits<double>::max(),
                                std::numeric_limits<double>::lowest()};
    for (int corner = 0; corner < 8; ++corner) {
        const double depth = glm::dot(corner_of(box, corner) - eye, forward);
        range = {std::min(range[0], depth), std::max(range[1], depth)};
    }
    return range;
}

Camera fit_camera(std::span<const Box3> boxes, const glm::dvec3& direction, const glm::dvec3& up,
                  const Camera& like, PixelSize size) {
    Box3 all;
    for (const Box3& box : boxes) {
        all.low = glm::min(all.low, box.low);
        all.high = glm::max(all.high, box.high);
    }
    if (all.empty()) {
        const Box3 cube{glm::dvec3(-1.0), glm::dvec3(1.0)};
        return fit_camera(std::span(&cube, 1), direction, up, like, size);
    }
    const glm::dvec3 middle = 0.5 * (all.low + all.high);
    const glm::dvec3 forward = glm::normalize(direction);
    Camera camera = like;
    camera.target = middle;
    camera.up = up;
    camera.eye = middle - forward;
    const View axes = make_view(camera, size);
    const bool perspective = camera.projection == Projection::perspective;
    const double aspect = static_cast<double>(size.width) / size.height;
    const double tangent = std::tan(0.5 * camera.fov_y);
    const double slope_x = perspective ? tangent * aspect : 0.0;
    const double slope_y = perspective ? tangent : 0.0;

    // The four planes through the picture's sides must have every corner inside: each side's plane
    // is the one that touches the outermost corner, and the eye lies where opposite planes meet (or
    // farther back).
    Sides sides;
    for (const Box3& box : boxes) {
        sides.include(box, middle, axes, slope_x, slope_y);
    }
    constexpr double margin = 1.04;
    const double extent = std::max(glm::length(all.high - all.low), 1e-6);
    double distance = 2.0 * extent;  // orthographic: only the near plane depends on it
    if (perspective) {
        distance = margin * std::max((sides.right + sides.left) / (2.0 * slope_x),
                                     (sides.top + sides.bottom) / (2.0 * slope_y));
        distance = std::max(distance, 1e-6);
    }
    camera.height_m =
        margin * std::max({(sides.right + sides.left) / aspect, sides.top + sides.bottom, 1e-9});
    const glm::dvec2 shift =
        perspective ? centring_shift(boxes, middle, axes, distance)
                    : 0.5 * glm::dvec2(sides.right - sides.left, sides.top - sides.bottom);
    camera.target = middle + shift.x * axes.right + shift.y * axes.up;
    camera.eye = camera.target - distance * forward;
    const std::array<double, 2> range = depth_range(all, camera.eye, forward);
    camera.near_m =
        perspective ? std::max(0.5 * range[0], 1e-4 * extent) : range[0] - 0.05 * extent;
    return camera;
}

Camera fit_camera(const Box3& box, const glm::dvec3& direction, const glm::dvec3& up,
                  const Camera& like, PixelSize size) {
    return fit_camera(std::span(&box, 1), direction, up, like, size);
}

std::optional<Camera> find_camera(std::string_view text, std::span<const Box3> boxes,
                                  const Camera& like, PixelSize size) {
    for (const NamedView& named : named_views) {
        if (named.name == text) {
            return fit_camera(boxes, named.direction, named.up, like, size);
        }
    }
    const std::optional<std::array<double, 9>> numbers = parse_numbers(text);
    if (!numbers) {
        return {};
    }
    const std::array<double, 9>& n = *numbers;
    Camera camera = like;
    camera.eye = {n[0], n[1], n[2]};
    camera.target = {n[3], n[4], n[5]};
    camera.up = {n[6], n[7], n[8]};
    const double distance = glm::distance(camera.eye, camera.target);
    if (!(distance > 0.0) || glm::length(camera.up) == 0.0) {
        return {};
    }
    camera.height_m = 2.0 * distance * std::tan(0.5 * camera.fov_y);
    camera.near_m = 1e-3 * distance;
    if (camera.projection == Projection::orthographic) {
        camera.near_m = 0.0;
    }
    return camera;
}

std::optional<Camera> find_camera(std::string_view text, const Box3& box, const Camera& like,
                                  PixelSize size) {
    return find_camera(text, std::span(&box, 1), like, size);
}

}  // namespace quartic
