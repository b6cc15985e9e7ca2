// Makes the shapes and grids of the benchmark of proxies.
#include "bench/proxy_shapes.h"

#include "bench/scenes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace quartic {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double fov = 30.0 * pi / 180.0;

// Of points spread over the surface, edges included.
template <class Shape>
double radius_around(const Shape& shape, const glm::dvec3& centre) {
    constexpr int steps = 64;
    double radius = 0.0;
    for (int face = 0; face < f64().face_count(shape); ++face) {
        for (int i = 0; i <= steps * (steps + 1) + steps; ++i) {
            const f64::vec2 uv(double(i % (steps + 1)) / steps, double(i / (steps + 1)) / steps);
            const f64::vec3 point = f64().point(shape, face, uv);
            radius = std::max(radius, glm::length(glm::dvec3(point) - centre));
        }
    }
    return radius;
}

template <class Shape>
ProxyShape make_shape(const std::string& name, const Shape& shape) {
    ProxyShape made;
    made.name = name;
    made.scene = empty_scene();
    add_part(made.scene, shape, Part());
    const auto box = f64().bounds(shape);
    made.centre = 0.5 * (glm::dvec3(box.low) + glm::dvec3(box.high));
    made.radius = radius_around(shape, made.centre);
    return made;
}

ProxyShape make_elbow(double bend_radius, double arc_deg) {
    const std::string name = "elbow " + std::to_string(std::lround(arc_deg)) + " deg, R/r " +
                             std::to_string(std::lround(bend_radius));
    return make_shape(name, f64::Torus{bend_radius, 1.0, arc_deg * pi / 180.0, 0.0});
}

// The size of a part as shaders/cull.comp sees it: the longest edge of its box at its nearest
// depth.
double seen_size(const Box3& box, const View& view) {
    const glm::dvec3 extent = box.high - box.low;
    const double largest = std::max({extent.x, extent.y, extent.z});
    return largest / (view.step * depth_range(box, view.eye, -view.back)[0]);
}

}  // namespace

std::vector<ProxyShape> make_proxy_shapes() {
    std::vector<ProxyShape> shapes;
    shapes.push_back(make_shape("torus 7:3", f64::Torus{7.0, 3.0, 2.0 * pi, 0.0}));
    shapes.push_back(make_shape("torus 9:1", f64::Torus{9.0, 1.0, 2.0 * pi, 0.0}));
    for (const double bend_radius : {2.0, 3.0, 6.0}) {
        shapes.push_back(make_elbow(bend_radius, 90.0));
    }
    for (const double arc_deg : {15.0, 45.0, 180.0}) {
        shapes.push_back(make_elbow(3.0, arc_deg));
    }
    for (const int slenderness : {1, 4, 12}) {
        shapes.push_back(make_shape("cylinder L/D " + std::to_string(slenderness),
                                    f64::Cylinder{0.5, double(slenderness), 0.0, 0.0}));
    }
    shapes.push_back(make_shape("cone 1:0.5, L/D 4", f64::Cone{0.5, 0.25, 4.0, 0.0}));
    shapes.push_back(make_shape("sphere", f64::Sphere{1.0, 0.0, 0.0, 0.0}));
    return shapes;
}

Camera random_camera(const ProxyShape& shape, int number, double distance) {
    constexpr std::uint64_t seed = 1;
    Random random(seed, static_cast<std::uint64_t>(number));
    const glm::dquat rotation = random_rotation(random);
    Camera camera;
    camera.fov_y = fov;
    camera.target = shape.centre;
    camera.eye = shape.centre + distance * shape.radius * (rotation * glm::dvec3(0.0, 0.0, 1.0));
    camera.up = rotation * glm::dvec3(0.0, 1.0, 0.0);
    camera.near_m = 0.01 * shape.radius;
    return camera;
}

void zoom_to(const ProxyShape& shape, Camera& camera) {
    constexpr double room = 1.02;
    camera.height_m = room * 2.0 * shape.radius;
    camera.fov_y = room * 2.0 * std::asin(shape.radius / glm::distance(camera.eye, shape.centre));
}

ProxyGrid make_proxy_grid(const ProxyShape& shape, int diameter_px, PixelSize size) {
    const double pitch = 2.0 * shape.radius;
    const int columns = (size.width + diameter_px - 1) / diameter_px;
    const int rows = (size.height + diameter_px - 1) / diameter_px;
    ProxyGrid grid;
    grid.scene = shape.scene;
    const Part one = shape.scene.parts[0];
    grid.scene.parts.clear();
    grid.camera.fov_y = fov;
    grid.camera.target = {0.0, 0.0, 0.0};
    grid.camera.up = {0.0, 1.0, 0.0};
    grid.camera.eye = {0.0, 0.0, 0.5 * pitch * size.height / diameter_px / std::tan(0.5 * fov)};
    grid.camera.near_m = 0.01 * shape.radius;
    const View view = make_view(grid.camera, size);
    double seen_px = 0.0;
    for (int i = 0; i < columns * rows; ++i) {
        Random random(1, static_cast<std::uint64_t>(i));
        Part part = one;
        part.placement.rotation = random_rotation(random);
        const glm::dvec3 place(i % columns - 0.5 * (columns - 1), i / columns - 0.5 * (rows - 1),
                               0.0);
        part.placement.position = pitch * place - part.placement.rotation * shape.centre;
        seen_px += seen_size(world_bounds(grid.scene, part), view);
        grid.scene.parts.push_back(part);
    }
    grid.seen_px = seen_px / (columns * rows);
    return grid;
}

}  // namespace quartic
