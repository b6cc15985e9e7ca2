// A pipe run has no gaps at its joints, and its normals go on smoothly where its walls do.
#include "scene/joints.h"
#include "generators/generate.h"
#include "tests/gpu/gpu_fixture.h"

#include <cmath>

namespace quartic {
namespace {

constexpr PixelSize picture_size{200, 160};
constexpr int view_count = 1000;

class JointsTest : public GpuTest {
protected:
    static const Scene& run() {
        static const Scene scene = [] {
            Result<Scene> made = generate("run", {});
            EXPECT_TRUE(made);
            find_joints(made.value());
            return std::move(made).value();
        }();
        return scene;
    }

    // Random but repeatable: from far to so close that joints are hundreds of pixels wide, and both
    // projections.
    static Camera camera_of(int index) {
        const Box3 box = world_bounds(run(), all_layers);
        Camera like;
        like.projection = index % 2 == 0 ? Projection::perspective : Projection::orthographic;
        Camera camera =
            fit_camera(box, spread_direction(index, view_count), {0.1, 0.2, 1}, like, picture_size);
        const double zoom = 1.0 + 7.0 * ((index * 7) % 10) / 10.0;
        camera.fov_y /= zoom;
        camera.height_m /= zoom;
        const Part& aim = run().parts[static_cast<std::size_t>(index) % run().parts.size()];
        camera.eye += aim.placement.position - camera.target;
        camera.target = aim.placement.position;
        return camera;
    }
};

TEST_F(JointsTest, the_run_is_joined_end_to_end) {
    ASSERT_GE(run().parts.size(), 5u);
    int open = 0;
    int smooth = 0;
    for (const Part& part : run().parts) {
        open += (part.open_ends & 1) + (part.open_ends >> 1 & 1);
        smooth += (part.smooth_ends & 1) + (part.smooth_ends >> 1 & 1);
    }
    EXPECT_GE(open, 8);
    EXPECT_GE(smooth, 4);
}

TEST_F(JointsTest, no_background_shows_inside_the_silhouette_in_a_thousand_views) {
    load(run());
    // What must be covered is what the same parts cover with all their caps on and no overlap.
    Scene sealed = run();
    for (Part& part : sealed.parts) {
        part.open_ends = 0;
    }
    const Reference silhouette(sealed, all_layers);
    const Reference reference(run(), all_layers);
    Comparison holes;
    Comparison errors;
    for (int i = 0; i < view_count; ++i) {
        const Camera camera = camera_of(i);
        const View view = make_view(camera, picture_size);
        const GBuffer picture = draw(camera, picture_size);
        compare(silhouette, view, picture_of(picture), holes);
        compare(reference, view, picture_of(picture), errors);
    }
    EXPECT_GT(holes.hit_pixels, 1000000u);
    EXPECT_EQ(holes.missed.hard, 0u);
    EXPECT_EQ(errors.missed.hard, 0u);
    EXPECT_EQ(errors.false_hits.hard, 0u);
    EXPECT_EQ(errors.wrong_id.hard, 0u);
    expect_no_gl_error();
}

TEST_F(JointsTest, normals_go_on_within_a_hundredth_of_a_degree_across_smooth_joints) {
    // On both sides of each smooth joint, along lines of the wall, the exact normals of the two
    // parts.
    f64 kernel;
    double worst_deg = 0.0;
    int compared = 0;
    for (const Part& part : run().parts) {
        visit_shape(run().shapes, part.type, part.shape, [&](const auto& shape) {
            for (int index = 0; index < kernel.end_count(shape); ++index) {
                if ((part.smooth_ends >> index & 1) == 0) {
                    continue;
                }
                const f64::End end = kernel.end(shape, index);
                const glm::dvec3 side = kernel.across(end.normal);
                for (int i = 0; i < 64; ++i) {
                    const double angle = 2.0 * 3.14159265358979 * i / 64.0;
                    const glm::dvec3 out =
                        std::cos(angle) * side + std::sin(angle) * glm::cross(end.normal, side);
                    const glm::dvec3 rim =
                        part.placement.position +
                        part.placement.rotation * (end.centre + end.radius * out);
                    const glm::dvec3 along = part.placement.rotation * end.normal;
                    const glm::dvec3 inwards = -(part.placement.rotation * out);
                    const Reference reference(run(), all_layers);
                    const auto normal_at = [&](double offset_m) {
                        const glm::dvec3 start =
                            rim + offset_m * along - 0.5 * end.radius * inwards;
                        return reference.trace({start, inwards, 0.0, 0.0}).normal;
                    };
                    const double sine = glm::length(glm::cross(normal_at(-1e-6), normal_at(1e-6)));
                    worst_deg = std::max(worst_deg,
                                         std::asin(std::min(1.0, sine)) * 180.0 / 3.14159265358979);
                    ++compared;
                }
            }
        });
    }
    EXPECT_GT(compared, 200);
    EXPECT_LE(worst_deg, 0.01);
}

}  // namespace
}  // namespace quartic
