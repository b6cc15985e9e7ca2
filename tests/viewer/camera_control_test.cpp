// The mouse's motions: what is held stays where it is held, z stays up, and walls can be passed.
#include "viewer/camera_control.h"

#include <gtest/gtest.h>

#include <cmath>

namespace quartic::viewer {
namespace {

constexpr PixelSize size{1200, 900};
constexpr glm::dvec3 point{3.0, 2.0, 1.5};

Camera sample_camera(Projection projection) {
    Camera camera;
    camera.eye = {-4.0, -9.0, 5.0};
    camera.target = {1.0, 1.0, 1.0};
    camera.projection = projection;
    camera.height_m = 7.0;
    camera.near_m = projection == Projection::perspective ? 0.01 : -5.0;
    return camera;
}

glm::dvec3 seen(const Camera& camera) {
    return project(make_view(camera, size), point);
}

class CameraControl : public testing::TestWithParam<Projection> {};
INSTANTIATE_TEST_SUITE_P(both, CameraControl,
                         testing::Values(Projection::perspective, Projection::orthographic));

TEST_P(CameraControl, orbit_keeps_the_pivot_in_place_and_does_not_roll) {
    Camera camera = sample_camera(GetParam());
    const glm::dvec3 before = seen(camera);
    for (int i = 0; i < 500; ++i) {
        camera = orbit(camera, point, 0.37, i % 2 == 0 ? 0.11 : -0.12);
    }
    const glm::dvec3 after = seen(camera);
    EXPECT_NEAR(after.x, before.x, 1e-6);
    EXPECT_NEAR(after.y, before.y, 1e-6);
    EXPECT_NEAR(after.z, before.z, 1e-9);
    EXPECT_NEAR(make_view(camera, size).right.z, 0.0, 1e-12);
}

TEST_P(CameraControl, orbit_stops_at_the_zenith_and_keeps_its_right_side_there) {
    Camera camera = sample_camera(GetParam());
    const glm::dvec3 right = make_view(camera, size).right;
    camera = orbit(camera, point, 0.0, -10.0);
    const View down = make_view(camera, size);
    EXPECT_NEAR(down.back.z, 1.0, 1e-12);
    EXPECT_NEAR(glm::distance(down.right, right), 0.0, 1e-9);
    camera = orbit(camera, point, 0.0, 0.4);
    EXPECT_NEAR(glm::distance(make_view(camera, size).right, right), 0.0, 1e-9);
    EXPECT_GT(make_view(camera, size).up.z, 0.0);
}

TEST_P(CameraControl, orbit_goes_on_from_a_view_from_the_top) {
    const Box3 box{glm::dvec3(-1.0), glm::dvec3(1.0)};
    const Camera top = *find_camera("top", box, sample_camera(GetParam()), size);
    const Camera same = orbit(top, {0.2, 0.1, 0.0}, 0.0, 0.0);
    EXPECT_NEAR(glm::distance(make_view(top, size).right, make_view(same, size).right), 0.0, 1e-9);
    EXPECT_NEAR(glm::distance(make_view(top, size).up, make_view(same, size).up), 0.0, 1e-9);
    EXPECT_NEAR(glm::distance(top.eye, same.eye), 0.0, 1e-9);
}

TEST_P(CameraControl, pan_carries_the_point_along_with_the_cursor) {
    Camera camera = sample_camera(GetParam());
    const glm::dvec3 before = seen(camera);
    const glm::dvec2 to(before.x + 210.0, before.y - 75.0);
    camera = pan(camera, size, {before.x, before.y}, to, before.z);
    EXPECT_NEAR(seen(camera).x, to.x, 1e-6);
    EXPECT_NEAR(seen(camera).y, to.y, 1e-6);
    EXPECT_NEAR(seen(camera).z, before.z, 1e-9);
}

TEST_P(CameraControl, zoom_keeps_the_point_under_the_cursor) {
    Camera camera = sample_camera(GetParam());
    const glm::dvec3 before = seen(camera);
    for (const double factor : {0.8, 0.5, 1.7, 0.9}) {
        camera = zoom(camera, size, {before.x, before.y}, seen(camera).z, factor, {});
        EXPECT_NEAR(seen(camera).x, before.x, 1e-6);
        EXPECT_NEAR(seen(camera).y, before.y, 1e-6);
    }
    const double scale = 0.8 * 0.5 * 1.7 * 0.9;
    if (GetParam() == Projection::perspective) {
        EXPECT_NEAR(seen(camera).z, scale * before.z, 1e-9);
    } else {
        EXPECT_NEAR(camera.height_m, scale * 7.0, 1e-9);
    }
}

TEST(CameraControlSteps, zoom_passes_a_wall_after_a_finite_number_of_steps) {
    Camera camera = sample_camera(Projection::perspective);
    const glm::dvec3 before = seen(camera);
    int steps = 0;
    while (seen(camera).z > 0.0 && steps < 1000) {
        camera = zoom(camera, size, {before.x, before.y}, seen(camera).z, 0.85, {0.01, 1e6});
        ++steps;
    }
    EXPECT_LT(steps, 60);
    EXPECT_GT(glm::dot(camera.target - camera.eye, make_view(camera, size).back), -1e3);
    EXPECT_GT(glm::distance(camera.target, camera.eye), 0.0);
}

TEST(CameraControlSteps, zoom_out_ends_at_the_reach) {
    Camera camera = sample_camera(Projection::perspective);
    for (int i = 0; i < 200; ++i) {
        const glm::dvec3 at = seen(camera);
        camera = zoom(camera, size, {at.x, at.y}, at.z, 1.25, {0.01, 500.0});
    }
    EXPECT_NEAR(glm::distance(camera.eye, point), 500.0, 0.1);
}

TEST(CameraControlSteps, toggled_projection_keeps_sizes_at_the_target_and_comes_back) {
    const Camera camera = sample_camera(Projection::perspective);
    const Camera other = toggle_projection(camera);
    const glm::dvec3 beside = camera.target + 0.5 * make_view(camera, size).right;
    const glm::dvec3 a = project(make_view(camera, size), beside);
    const glm::dvec3 b = project(make_view(other, size), beside);
    EXPECT_NEAR(a.x, b.x, 1e-6);
    EXPECT_NEAR(a.y, b.y, 1e-6);
    EXPECT_NEAR(glm::distance(toggle_projection(other).eye, camera.eye), 0.0, 1e-9);
}

TEST(CameraControlSteps, near_plane_lies_before_the_box_and_is_never_zero_inside) {
    const Box3 box{glm::dvec3(-10.0), glm::dvec3(10.0)};
    Camera camera;
    camera.eye = {0.0, -50.0, 0.0};
    EXPECT_NEAR(with_near_plane(camera, box, 40.0).near_m, 20.0, 1e-9);
    camera.eye = {0.0, -1.0, 0.0};
    EXPECT_GT(with_near_plane(camera, box, 0.0).near_m, 0.0);
    EXPECT_LT(with_near_plane(camera, box, 0.05).near_m, 0.05);
    camera.projection = Projection::orthographic;
    EXPECT_LT(with_near_plane(camera, box, 1.0).near_m, -9.0);
}

}  // namespace
}  // namespace quartic::viewer
