// Cameras, and the one map from a pixel to its ray that the GPU, the reference and picking share.
#pragma once

#include "scene/scene.h"

#include <optional>
#include <span>
#include <string_view>

namespace quartic {

enum class Projection { perspective, orthographic };

struct Camera {
    glm::dvec3 eye{0.0, -10.0, 0.0};
    glm::dvec3 target{0.0};
    glm::dvec3 up{0.0, 0.0, 1.0};
    Projection projection = Projection::perspective;
    double fov_y = 0.6;     // radians, perspective
    double height_m = 1.0;  // of the picture, orthographic
    double near_m =
        0.01;  // depth of the near plane; > 0 in perspective, any number in orthographic
};

struct PixelSize {
    int width = 0;
    int height = 0;
    bool operator==(const PixelSize&) const = default;
};

inline std::size_t pixel_count(PixelSize size) {
    return static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
}
// Where a pixel stands in a picture's arrays.
inline std::size_t pixel_index(PixelSize size, int x, int y) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width) +
           static_cast<std::size_t>(x);
}

// A camera resolved for a picture: unit axes in the world, x right, y up, z backwards (out of the
// picture).
//
// Pixel (x, y), counted from the lower left, has its centre at (x + 0.5, y + 0.5). The parameter t
// of a pixel's ray is its view depth: the distance from the eye's plane, in both projections.
struct View {
    glm::dvec3 eye;
    glm::dvec3 right;
    glm::dvec3 up;
    glm::dvec3 back;
    Projection projection;
    double step;  // of a pixel: tangent (perspective) or metres (orthographic)
    double near_m;
    double focus_m;  // the target's depth in orthographic views, where depths are finest; else 0
    double far_m;    // orthographic views clip what lies deeper; perspective sees to infinity
    PixelSize size;
};

View make_view(const Camera& camera, PixelSize size);

// The ray through a point of the picture, in pixels; first is the near plane's depth.
f64::Ray pixel_ray(const View& view, double x, double y);

// The point of the picture, in pixels, where a world point appears, and its depth.
glm::dvec3 project(const View& view, const glm::dvec3& world);

// Directions spread evenly over the sphere (a Fibonacci spiral), turned about z.
glm::dvec3 spread_direction(int index, int count, double turn = 0.0);

// Depth as the depth buffer holds it (shaders/camera.glsl), and back.
double buffer_depth(const View& view, double depth_m);
double depth_from_buffer(const View& view, double buffer_depth);

// The least and the greatest depth of a box for an eye that looks along forward (unit).
std::array<double, 2> depth_range(const Box3& box, const glm::dvec3& eye,
                                  const glm::dvec3& forward);

// Looks along a direction so that all boxes (those of the parts, or one around them) just fill the
// picture.
Camera fit_camera(std::span<const Box3> boxes, const glm::dvec3& direction, const glm::dvec3& up,
                  const Camera& like, PixelSize size);
Camera fit_camera(const Box3& box, const glm::dvec3& direction, const glm::dvec3& up,
                  const Camera& like, PixelSize size);

// "fit", "iso", "front", "back", "left", "right", "top", "bottom", or "ex,ey,ez;tx,ty,tz;ux,uy,uz"
// (eye, target, up).
std::optional<Camera> find_camera(std::string_view text, std::span<const Box3> boxes,
                                  const Camera& like, PixelSize size);
std::optional<Camera> find_camera(std::string_view text, const Box3& box, const Camera& like,
                                  PixelSize size);

}  // namespace quartic
