// How the mouse moves a camera: orbit, pan and zoom as pure functions. World z stays up; nothing
// rolls.
#pragma once

#include "scene/camera.h"

#include <glm/glm.hpp>

namespace quartic::viewer {

// Turns around a pivot, which keeps its place in the picture: by yaw around world z, then by pitch
// towards the zenith. The elevation stops at straight up and straight down.
Camera orbit(const Camera& camera, const glm::dvec3& pivot, double yaw, double pitch);

// Moves across so that what is seen at from_px (depth: its view depth) is then seen at to_px.
// Pixels count from the lower left, as in pixel_ray.
Camera pan(const Camera& camera, PixelSize size, const glm::dvec2& from_px, const glm::dvec2& to_px,
           double depth_m);

struct ZoomLimits {
    double step_min_m =
        1e-4;  // in perspective each step goes at least that far, so that walls can be passed
    double reach_m =
        1e6;  // farthest from the point, and the greatest height of an orthographic picture
};

// Scales the distance to the point at at_px by factor (< 1: nearer); the point keeps its place in
// the picture.
Camera zoom(const Camera& camera, PixelSize size, const glm::dvec2& at_px, double depth_m,
            double factor, const ZoomLimits& limits);

// Perspective becomes orthographic and back; what lies at the target's depth keeps its size.
Camera toggle_projection(const Camera& camera);

// Moves the target along the line of sight to this depth, where orbits and projections take it
// from.
Camera with_target_depth(const Camera& camera, double depth_m);

// Sets the near plane: in front of the box where the eye is outside, and a small part of the depth
// of interest where the eye is inside; never 0 in perspective.
Camera with_near_plane(const Camera& camera, const Box3& box, double interest_m);

// The point of the world that is seen at a pixel, at a view depth.
glm::dvec3 point_at(const Camera& camera, PixelSize size, const glm::dvec2& at_px, double depth_m);

}  // namespace quartic::viewer
