// Camera motions in double, without a window.
#include "viewer/camera_control.h"

#include <algorithm>
#include <cmath>

namespace quartic::viewer {
namespace {

// A view's direction as two angles, so that repeated turns neither roll nor drift.
struct Heading {
    double azimuth;    // of the line of sight around z, from +x
    double elevation;  // of the line of sight over the horizon
};

constexpr double half_turn = 3.14159265358979323846;

Heading heading_of(const Camera& camera) {
    const glm::dvec3 forward = glm::normalize(camera.target - camera.eye);
    const double level = std::hypot(forward.x, forward.y);
    if (level > 1e-9) {
        return {std::atan2(forward.y, forward.x), std::atan2(forward.z, level)};
    }
    // Straight up or down: the picture's upper side says where the front is.
    const double side = forward.z < 0.0 ? 1.0 : -1.0;
    return {std::atan2(side * camera.up.y, side * camera.up.x),
            std::copysign(0.5 * half_turn, forward.z)};
}

struct Axes {
    glm::dvec3 right;
    glm::dvec3 up;
    glm::dvec3 forward;
};

Axes axes_of(const Heading& heading) {
    const double c = std::cos(heading.azimuth);
    const double s = std::sin(heading.azimuth);
    const double level = std::cos(heading.elevation);
    const double rise = std::sin(heading.elevation);
    return {{s, -c, 0.0}, {-rise * c, -rise * s, level}, {level * c, level * s, rise}};
}

}  // namespace

Camera orbit(const Camera& camera, const glm::dvec3& pivot, double yaw, double pitch) {
    const Heading before = heading_of(camera);
    const Heading after{before.azimuth + yaw,
                        std::clamp(before.elevation + pitch, -0.5 * half_turn, 0.5 * half_turn)};
    const Axes from = axes_of(before);
    const Axes to = axes_of(after);
    const auto turned = [&](const glm::dvec3& p) {
        const glm::dvec3 d = p - pivot;
        return pivot + glm::dot(from.right, d) * to.right + glm::dot(from.up, d) * to.up +
               glm::dot(from.forward, d) * to.forward;
    };
    Camera moved = camera;
    moved.eye = turned(camera.eye);
    moved.target = moved.eye + glm::distance(camera.eye, camera.target) * to.forward;
    moved.up = to.up;
    return moved;
}

glm::dvec3 point_at(const Camera& camera, PixelSize size, const glm::dvec2& at_px, double depth_m) {
    const f64::Ray ray = pixel_ray(make_view(camera, size), at_px.x, at_px.y);
    return ray.origin + depth_m * ray.direction;
}

Camera pan(const Camera& camera, PixelSize size, const glm::dvec2& from_px, const glm::dvec2& to_px,
           double depth_m) {
    const glm::dvec3 shift =
        point_at(camera, size, from_px, depth_m) - point_at(camera, size, to_px, depth_m);
    Camera moved = camera;
    moved.eye += shift;
    moved.target += shift;
    return moved;
}

Camera zoom(const Camera& camera, PixelSize size, const glm::dvec2& at_px, double depth_m,
            double factor, const ZoomLimits& limits) {
    const glm::dvec3 point = point_at(camera, size, at_px, depth_m);
    Camera moved = camera;
    if (camera.projection == Projection::orthographic) {
        moved.height_m =
            std::clamp(camera.height_m * factor, 10.0 * limits.step_min_m, 2.0 * limits.reach_m);
        const View view = make_view(camera, size);
        const glm::dvec3 across =
            point - camera.eye + glm::dot(view.back, camera.eye - point) * view.back;
        const glm::dvec3 shift = (1.0 - moved.height_m / camera.height_m) * across;
        moved.eye += shift;
        moved.target += shift;
        return moved;
    }
    const glm::dvec3 sight = point - camera.eye;
    const double length = glm::length(sight);
    if (!(length > 0.0)) {
        return moved;
    }
    double step = length * (1.0 - factor);
    step = factor < 1.0 ? std::max(step, limits.step_min_m) : std::min(step, -limits.step_min_m);
    step = std::max(step, std::min(0.0, length - limits.reach_m));
    const glm::dvec3 forward = glm::normalize(camera.target - camera.eye);
    const double ahead =
        glm::distance(camera.eye, camera.target) * std::max(1.0 - step / length, 0.05);
    moved.eye += step / length * sight;
    moved.target = moved.eye + std::max(ahead, limits.step_min_m) * forward;
    return moved;
}

Camera toggle_projection(const Camera& camera) {
    Camera other = camera;
    const double tangent = 2.0 * std::tan(0.5 * camera.fov_y);
    if (camera.projection == Projection::perspective) {
        other.projection = Projection::orthographic;
        other.height_m = tangent * glm::distance(camera.eye, camera.target);
    } else {
        other.projection = Projection::perspective;
        const glm::dvec3 forward = glm::normalize(camera.target - camera.eye);
        other.eye = camera.target - camera.height_m / tangent * forward;
    }
    return other;
}

Camera with_target_depth(const Camera& camera, double depth_m) {
    Camera other = camera;
    other.target = camera.eye + depth_m * glm::normalize(camera.target - camera.eye);
    return other;
}

Camera with_near_plane(const Camera& camera, const Box3& box, double interest_m) {
    Camera other = camera;
    const Box3 seen = box.empty() ? Box3{glm::dvec3(-1.0), glm::dvec3(1.0)} : box;
    const glm::dvec3 forward = glm::normalize(camera.target - camera.eye);
    const double nearest = depth_range(seen, camera.eye, forward)[0];
    const double extent = std::max(glm::length(seen.high - seen.low), 1e-6);
    if (camera.projection == Projection::orthographic) {
        other.near_m = nearest - 0.05 * extent;
        return other;
    }
    // A reversed float depth keeps its relative accuracy however near the plane is.
    const double inside = std::clamp(0.01 * interest_m, 1e-7 * extent, 1e-4 * extent);
    other.near_m = std::max(0.5 * nearest, inside);
    return other;
}

}  // namespace quartic::viewer
