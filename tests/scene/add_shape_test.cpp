// What becomes of shapes with a zero dimension.
#include "scene/add_shape.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace quartic {
namespace {

constexpr double full_turn = 2.0 * std::numbers::pi;

struct AddedTo {
    Added added;
    Scene scene;
};

// Placed at (1, 2, 3), turned so that the local x axis is the world's y axis.
template <class Shape>
AddedTo add(const Shape& shape) {
    AddedTo outcome;
    Part part;
    part.placement.position = {1.0, 2.0, 3.0};
    part.placement.rotation = glm::angleAxis(0.5 * std::numbers::pi, glm::dvec3(0.0, 0.0, 1.0));
    part.open_ends = 3;
    outcome.added = add_shape(outcome.scene, shape, part);
    return outcome;
}

template <class Shape>
void expect_nothing(const Shape& shape) {
    const AddedTo outcome = add(shape);
    EXPECT_FALSE(outcome.added.drawn);
    EXPECT_FALSE(outcome.added.reason.empty());
    EXPECT_TRUE(outcome.scene.parts.empty());
}

void expect_disc(const AddedTo& outcome, double radius, const glm::dvec3& centre) {
    EXPECT_TRUE(outcome.added.drawn);
    EXPECT_FALSE(outcome.added.reason.empty());
    ASSERT_EQ(outcome.scene.shapes.disk.size(), 1u);
    EXPECT_EQ(outcome.scene.shapes.disk[0].radius, radius);
    EXPECT_EQ(outcome.scene.shapes.disk[0].inner_radius, 0.0);
    EXPECT_LT(glm::length(outcome.scene.parts[0].placement.position - centre), 1e-12);
    EXPECT_EQ(outcome.scene.parts[0].open_ends, 0);
}

TEST(AddShape, sound_shapes_are_added_without_a_reason) {
    const AddedTo outcome = add(f64::Torus{0.3, 0.1, 1.0, 0});
    EXPECT_TRUE(outcome.added.drawn);
    EXPECT_TRUE(outcome.added.reason.empty());
    EXPECT_EQ(outcome.scene.parts[0].open_ends, 3);
}

TEST(AddShape, cylinder_of_zero_height_is_a_disc) {
    expect_disc(add(f64::Cylinder{0.5, 0.0, 0, 0}), 0.5, {1.0, 2.0, 3.0});
}

TEST(AddShape, dish_of_zero_height_is_a_disc) {
    expect_disc(add(f64::Dish{0.5, 0.0, 1, 0}), 0.5, {1.0, 2.0, 3.0});
}

TEST(AddShape, cone_of_zero_height_is_its_bigger_disc) {
    expect_disc(add(f64::Cone{0.2, 0.5, 0.0, 0}), 0.5, {1.0, 2.0, 3.0});
}

TEST(AddShape, disc_of_an_offset_snout_stands_where_its_bigger_circle_does) {
    expect_disc(add(f64::Snout{0.5, 0.4, 0.0, 0.1, 0, 0, 0, 0}), 0.5, {1.0, 1.95, 3.0});
    expect_disc(add(f64::Snout{0.4, 0.5, 0.0, 0.1, 0, 0, 0, 0}), 0.5, {1.0, 2.05, 3.0});
}

TEST(AddShape, reasons_tell_when_the_smaller_circle_overhangs) {
    EXPECT_NE(add(f64::Snout{0.5, 0.4, 0.0, 0.1, 0, 0, 0, 0}).added.reason,
              add(f64::Snout{0.5, 0.4, 0.0, 0.3, 0, 0, 0, 0}).added.reason);
}

TEST(AddShape, sheared_snout_of_zero_height_is_a_level_disc) {
    expect_disc(add(f64::Snout{0.5, 0.5, 0.0, 0.0, 0.2, 0, 0, 0}), 0.5, {1.0, 2.0, 3.0});
}

TEST(AddShape, a_zero_radius_is_a_tip_or_nothing) {
    EXPECT_TRUE(add(f64::Cone{0.5, 0.0, 1.0, 0}).added.reason.empty());
    EXPECT_TRUE(add(f64::Snout{0.0, 0.5, 1.0, 0.2, 0, 0, 0, 0}).added.drawn);
    expect_nothing(f64::Cone{0.0, 0.0, 1.0, 0});
    expect_nothing(f64::Snout{0.0, 0.0, 1.0, 0.2, 0, 0, 0, 0});
    expect_nothing(f64::Cylinder{0.0, 1.0, 0, 0});
    expect_nothing(f64::Sphere{0.0, 0, 0, 0});
    expect_nothing(f64::Dish{0.0, 1.0, 0, 0});
    expect_nothing(f64::Torus{0.5, 0.0, 1.0, 0});
    expect_nothing(f64::Disk{0.0, 0.0, 0, 0});
}

TEST(AddShape, a_zero_arc_is_nothing) {
    expect_nothing(f64::Torus{0.5, 0.1, 0.0, 0});
    expect_nothing(f64::RectangularTorus{0.2, 0.5, 0.1, 0.0});
}

TEST(AddShape, simple_snouts_are_cones_and_simple_cones_are_cylinders) {
    const AddedTo cone = add(f64::Snout{0.5, 0.4, 1.0, 0, 0, 0, 0, 0});
    EXPECT_EQ(cone.scene.shapes.cone.size(), 1u);
    EXPECT_TRUE(cone.added.reason.empty());
    const AddedTo cylinder = add(f64::Snout{0.5, 0.5, 1.0, 0, 0, 0, 0, 0});
    ASSERT_EQ(cylinder.scene.shapes.cylinder.size(), 1u);
    EXPECT_EQ(cylinder.scene.shapes.cylinder[0].height, 1.0);
    EXPECT_TRUE(cylinder.added.reason.empty());
}

TEST(AddShape, an_arc_that_rounding_made_too_long_is_a_full_turn) {
    const AddedTo outcome = add(f64::Torus{0.5, 0.1, full_turn + 5e-7, 0});
    ASSERT_TRUE(outcome.added.drawn);
    EXPECT_EQ(outcome.scene.shapes.torus[0].arc, full_turn);
    expect_nothing(f64::Torus{0.5, 0.1, full_turn + 1e-3, 0});
}

TEST(AddShape, a_bend_that_rounding_made_too_tight_touches_its_axis) {
    const double radius = 0.1;
    EXPECT_TRUE(add(f64::Torus{radius * (1.0 - 1e-7), radius, 1.0, 0}).added.drawn);
    expect_nothing(f64::Torus{0.09, radius, 1.0, 0});
}

TEST(AddShape, flat_boxes_are_drawn_and_lines_are_not) {
    EXPECT_TRUE(add(f64::Box{1.0, 2.0, 0.0, 0}).added.drawn);
    expect_nothing(f64::Box{1.0, 0.0, 0.0, 0});
}

TEST(AddShape, pyramid_of_zero_height_is_its_bigger_rectangle) {
    const AddedTo outcome = add(f64::Pyramid{0.5, 0.4, 0.2, 0.1, 0.2, 0.0, 0.0, 0});
    ASSERT_EQ(outcome.scene.shapes.box.size(), 1u);
    EXPECT_EQ(outcome.scene.shapes.box[0].length_x, 0.5);
    EXPECT_EQ(outcome.scene.shapes.box[0].length_z, 0.0);
    EXPECT_LT(glm::length(outcome.scene.parts[0].placement.position - glm::dvec3(1.0, 1.9, 3.0)),
              1e-12);
}

TEST(AddShape, a_pyramid_of_zero_width_is_a_plate) {
    EXPECT_EQ(add(f64::Pyramid{0.0, 0.5, 0.0, 0.5, 0, 0, 1.0, 0}).scene.shapes.box.size(), 1u);
    const AddedTo trapezium = add(f64::Pyramid{0.0, 0.5, 0.0, 0.2, 0, 0, 1.0, 0});
    ASSERT_EQ(trapezium.scene.shapes.pyramid.size(), 1u);
    EXPECT_EQ(find_fault(trapezium.scene.shapes.pyramid[0]), "");
    EXPECT_LT(trapezium.scene.shapes.pyramid[0].bottom_x, 1e-3);
    expect_nothing(f64::Pyramid{0.0, 0.0, 0.0, 0.0, 0, 0, 1.0, 0});
}

TEST(AddShape, what_makes_no_sense_is_refused) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    expect_nothing(f64::Cylinder{0.5, -1.0, 0, 0});
    expect_nothing(f64::Cylinder{-0.5, 1.0, 0, 0});
    expect_nothing(f64::Cylinder{nan, 0.0, 0, 0});
    expect_nothing(f64::Cylinder{infinity, 1.0, 0, 0});
    expect_nothing(f64::Cylinder{0.5, nan, 0, 0});
    expect_nothing(f64::Snout{0.5, -0.1, 0.0, 0, 0, 0, 0, 0});
    expect_nothing(f64::Snout{0.5, nan, 0.0, 0, 0, 0, 0, 0});
    expect_nothing(f64::Snout{0.5, 0.4, 0.0, infinity, 0, 0, 0, 0});
    expect_nothing(f64::Snout{0.5, 0.4, 0.1, 0.0, 50.0, 0, 0, 0});
    expect_nothing(f64::Pyramid{nan, 0.4, 0.2, 0.1, 0, 0, 0.0, 0});
    expect_nothing(f64::Pyramid{0.5, 0.4, 0.2, 0.1, infinity, 0, 0.0, 0});
    expect_nothing(f64::Torus{0.5, 0.1, -1.0, 0});
    expect_nothing(f64::RectangularTorus{0.5, 0.5, 0.1, 1.0});
}

}  // namespace
}  // namespace quartic
