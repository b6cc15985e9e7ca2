// What the benchmarks of solvers draw: rings as shapes and as polygons, one and many, and algebraic
// surfaces.
#pragma once

#include "generators/random.h"
#include "scene/camera.h"
#include "scene/polynomial3.h"
#include "scene/scene.h"

#include <array>
#include <cstdint>
#include <numbers>

namespace quartic {

// The ring of de Toledo, Levy, Paul 2007, section 5: both radii sum to 1.
constexpr f64::Torus test_ring{0.7, 0.3, 2.0 * std::numbers::pi, 0.0};

// One node and one material, and nothing in it.
Scene empty_scene();

// Evenly spread rotations (Shoemake 1992, Graphics Gems III, "Uniform random rotations").
glm::dquat random_rotation(Random& random);

// As the GPU has it.
f32::Torus float_ring();

// One ring at the origin, around z.
Scene ring_scene();

// The same as N rings of N sides each, with the normals of the ring.
Scene polygon_ring_scene(int sides);

// So many rings with random axes in a grid that fills [-1, 1]^2 across the view; sides > 0: as
// polygons, all parts instances of one mesh. The same for every call, on any machine.
Scene ring_grid_scene(std::uint64_t count, int sides);

// Looks along -z at that grid so that its front just fills the picture.
Camera ring_grid_camera(std::uint64_t count);

// The zero set of a cubic or quartic in the cube [-1, 1]^3, unmoved.
Scene surface_scene(const Polynomial3& polynomial);

// Its coefficients as the GPU has them.
std::array<float, 35> float_terms(const Polynomial3& polynomial);

// The camera of the paper's table 1: fov 30 degrees, 5.579 away; at 0 degrees it looks along the
// axis, at 90 from the side.
Camera ring_camera(double angle_deg);

}  // namespace quartic
