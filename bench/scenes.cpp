// Makes the scenes of the solvers' benchmarks.
#include "bench/scenes.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>

namespace quartic {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double eye_distance = 5.579;  // gives the paper's counts of pixels

// Rings in a grid, `side` by `side` across the view and as many layers as it takes.
struct RingGrid {
    std::uint64_t side;
    std::uint64_t layers;
    double pitch;  // of the grid; the rings nearly touch

    // As deep as it is wide, so that rings lie on each other the more the more there are.
    explicit RingGrid(std::uint64_t count)
        : side(static_cast<std::uint64_t>(std::lround(std::cbrt(static_cast<double>(count))))),
          layers((count + side * side - 1) / (side * side)),
          pitch(2.0 / static_cast<double>(side)) {}

    glm::dvec3 place(std::uint64_t index) const {
        const glm::dvec3 cell(static_cast<double>(index % side),
                              static_cast<double>(index / side % side),
                              -static_cast<double>(index / side / side));
        return pitch * (cell + glm::dvec3(0.5, 0.5, -0.5)) - glm::dvec3(1.0, 1.0, 0.0);
    }
};

f64::Torus ring_of_size(double outer_radius) {
    f64::Torus ring = test_ring;
    ring.bend_radius *= outer_radius;
    ring.radius *= outer_radius;
    return ring;
}

Mesh polygon_ring(const f64::Torus& ring, int sides) {
    Mesh mesh;
    const auto number = [&](int i, int j) {
        return static_cast<std::uint32_t>((i % sides) * sides + j % sides);
    };
    for (int i = 0; i < sides; ++i) {
        for (int j = 0; j < sides; ++j) {
            const double around_axis = 2.0 * pi * i / sides;
            const double around_tube = 2.0 * pi * j / sides;
            const glm::dvec3 out(std::cos(around_axis), std::sin(around_axis), 0.0);
            const glm::dvec3 normal =
                std::cos(around_tube) * out + std::sin(around_tube) * glm::dvec3(0.0, 0.0, 1.0);
            mesh.positions.emplace_back(ring.bend_radius * out + ring.radius * normal);
            mesh.normals.emplace_back(normal);
            for (const std::uint32_t corner :
                 {number(i, j), number(i + 1, j), number(i + 1, j + 1), number(i, j),
                  number(i + 1, j + 1), number(i, j + 1)}) {
                mesh.indices.push_back(corner);
            }
        }
    }
    return mesh;
}

}  // namespace

Scene empty_scene() {
    Scene scene;
    scene.nodes.emplace_back();
    scene.materials.emplace_back();
    return scene;
}

glm::dquat random_rotation(Random& random) {
    const double part = random.between(0.0, 1.0);
    const double first = random.between(0.0, 2.0 * pi);
    const double second = random.between(0.0, 2.0 * pi);
    const double a = std::sqrt(1.0 - part);
    const double b = std::sqrt(part);
    return {b * std::cos(second), a * std::sin(first), a * std::cos(first), b * std::sin(second)};
}

f32::Torus float_ring() {
    return {static_cast<float>(test_ring.bend_radius), static_cast<float>(test_ring.radius),
            static_cast<float>(test_ring.arc), 0.0f};
}

Scene ring_scene() {
    Scene scene = empty_scene();
    add_part(scene, test_ring, Part());
    return scene;
}

Scene polygon_ring_scene(int sides) {
    Scene scene = empty_scene();
    add_mesh_part(scene, polygon_ring(test_ring, sides), Part());
    return scene;
}

Scene ring_grid_scene(std::uint64_t count, int sides) {
    const RingGrid grid(count);
    const f64::Torus ring = ring_of_size(0.49 * grid.pitch);
    Scene scene = empty_scene();
    if (sides > 0) {
        scene.meshes.push_back(polygon_ring(ring, sides));
    } else {
        scene.shapes.torus.push_back(ring);
    }
    for (std::uint64_t i = 0; i < count; ++i) {
        Random random(1, i);
        Part part;
        part.placement = {grid.place(i), random_rotation(random)};
        part.type = sides > 0 ? ShapeType::mesh : ShapeType::torus;
        scene.parts.push_back(part);
    }
    return scene;
}

Scene surface_scene(const Polynomial3& polynomial) {
    Scene scene = empty_scene();
    if (polynomial.degree() <= 3) {
        f64::CubicSurface surface{};
        const std::array<double, 20> terms = polynomial.cubic_terms();
        std::memcpy(&surface, terms.data(), sizeof(terms));
        surface.half_size = 1.0;
        add_part(scene, surface, Part());
    } else {
        f64::QuarticSurface surface{};
        const auto& terms = polynomial.terms();
        std::memcpy(&surface, terms.data(), sizeof(terms));
        surface.half_size = 1.0;
        add_part(scene, surface, Part());
    }
    return scene;
}

std::array<float, 35> float_terms(const Polynomial3& polynomial) {
    std::array<float, 35> terms{};
    std::transform(polynomial.terms().begin(), polynomial.terms().end(), terms.begin(),
                   [](double term) { return static_cast<float>(term); });
    return terms;
}

Camera ring_grid_camera(std::uint64_t count) {
    const RingGrid grid(count);
    Camera camera;
    camera.fov_y = 30.0 * pi / 180.0;
    camera.up = {0.0, 1.0, 0.0};
    camera.eye = {0.0, 0.0, 1.0 / std::tan(0.5 * camera.fov_y)};
    camera.target = {0.0, 0.0, -0.5 * grid.pitch * static_cast<double>(grid.layers)};
    camera.near_m = 0.1;
    return camera;
}

Camera ring_camera(double angle_deg) {
    const double angle = angle_deg * pi / 180.0;
    const glm::dvec3 back(std::sin(angle), 0.0, std::cos(angle));
    Camera camera;
    camera.fov_y = 30.0 * pi / 180.0;
    camera.eye = eye_distance * back;
    camera.up = glm::cross(back, glm::dvec3(0.0, 1.0, 0.0));
    camera.near_m = 1.0;
    return camera;
}

}  // namespace quartic
