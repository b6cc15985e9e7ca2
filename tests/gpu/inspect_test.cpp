// What an inspected frame records: each ray's cost and the ray itself, with the same picture as
// before.
#include "scene/add_shape.h"
#include "solvers/solver_table.h"
#include "tests/gpu/gpu_fixture.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace quartic {
namespace {

constexpr PixelSize picture_size{200, 150};
constexpr int sturm_halvings = 20;  // solvers/sturm.glsl

class InspectTest : public GpuTest {
protected:
    InspectTest() {
        scene_.nodes.push_back({});
        scene_.kinds = {"torus"};
        camera_.eye = {3.0, -5.0, 4.0};
        camera_.target = {0.0, 0.0, 0.0};
        camera_.near_m = 0.1;
    }

    void add_ring() { add_shape(scene_, f64::Torus{1.0, 0.4, 2.0 * std::numbers::pi, 0.0}, {}); }

    GBuffer inspect(std::string_view solver) {
        PackOptions packing;
        packing.solver = find_solver(solver)->id;
        EXPECT_TRUE(renderer().load(pack(scene_, packing)));
        RenderOptions options = all_parts();
        options.inspect = true;
        EXPECT_TRUE(renderer().draw(camera_, picture_size, options));
        GBuffer picture = renderer().read();
        EXPECT_EQ(picture.rays.size(), picture.ids.size());
        return picture;
    }

    Scene scene_;
    Camera camera_;
};

TEST_F(InspectTest, changes_no_pixel_of_the_picture) {
    add_ring();
    add_shape(scene_, f64::Box{0.5, 0.5, 0.5, 0.0}, {});
    const GBuffer inspected = inspect("convexity_split");
    ASSERT_TRUE(renderer().draw(camera_, picture_size, all_parts()));
    const GBuffer plain = renderer().read();
    EXPECT_EQ(inspected.ids, plain.ids);
    EXPECT_EQ(inspected.depth_m, plain.depth_m);
    EXPECT_EQ(inspected.colours, plain.colours);
    EXPECT_TRUE(plain.rays.empty());
    expect_no_gl_error();
}

TEST_F(InspectTest, rays_are_counted_where_they_miss_and_where_they_hit) {
    add_ring();
    const GBuffer picture = inspect("convexity_split");
    int hits = 0;
    int misses = 0;
    int untouched = 0;
    for (std::size_t i = 0; i < picture.ids.size(); ++i) {
        const bool is_hit = picture.ids[i] != no_index;
        // A ring's hull may stand before itself: then its ray is solved again.
        ASSERT_LE(picture.rays[i], 4);
        ASSERT_TRUE(picture.rays[i] > 0 || !is_hit) << "pixel " << i;
        hits += is_hit;
        misses += !is_hit && picture.rays[i] > 0;
        untouched += picture.rays[i] == 0;
        ASSERT_EQ(picture.ray_directions[i].w > -1e17f, is_hit || picture.rays[i] == 0);
    }
    EXPECT_GT(hits, 1000);
    EXPECT_GT(misses, 100);
    EXPECT_GT(untouched, 1000);
}

TEST_F(InspectTest, two_parts_of_a_pixel_cost_twice_the_rays) {
    add_ring();
    const GBuffer one = inspect("convexity_split");
    add_ring();
    const GBuffer two = inspect("convexity_split");
    for (std::size_t i = 0; i < one.ids.size(); ++i) {
        ASSERT_EQ(two.rays[i], 2 * one.rays[i]) << "pixel " << i;
        ASSERT_EQ(two.steps[i], 2 * one.steps[i]) << "pixel " << i;
    }
}

TEST_F(InspectTest, sturm_pays_its_halvings_and_convexity_split_a_few_steps) {
    add_ring();
    const GBuffer halved = inspect("sturm");
    const GBuffer split = inspect("convexity_split");
    double split_steps = 0.0;
    double hits = 0.0;
    for (std::size_t i = 0; i < halved.ids.size(); ++i) {
        if (halved.ids[i] != no_index) {
            ASSERT_EQ(halved.steps[i], sturm_halvings * halved.rays[i]) << "pixel " << i;
            hits += split.rays[i];
            split_steps += split.steps[i];
        }
    }
    ASSERT_GT(hits, 1000.0);
    EXPECT_GT(split_steps / hits, 1.0);
    EXPECT_LT(split_steps / hits, 0.5 * sturm_halvings);
}

TEST_F(InspectTest, a_recorded_ray_solved_in_cpp_has_the_recorded_root) {
    add_ring();
    const GBuffer picture = inspect("convexity_split");
    const f32::Torus torus{1.0f, 0.4f, static_cast<float>(2.0 * std::numbers::pi), 0.0f};
    int rays = 0;
    int alike = 0;
    for (std::size_t i = 0; i < picture.ids.size(); ++i) {
        if (picture.rays[i] == 0) {
            continue;
        }
        const glm::vec4 origin = picture.ray_origins[i];
        const glm::vec4 direction = picture.ray_directions[i];
        const f32::Ray ray{glm::vec3(origin), glm::vec3(direction), origin.w,
                           picture.ray_pixels[i]};
        const f32::Hit found = f32().hit(torus, ray, 0, solver_default);
        const bool is_hit = picture.ids[i] != no_index;
        ++rays;
        alike += found.found == is_hit && (!is_hit || std::abs(found.t - direction.w) < 2e-5f);
    }
    EXPECT_GT(rays, 1000);
    EXPECT_GE(alike, rays - rays / 1000);
}

TEST_F(InspectTest, a_solver_chosen_for_a_draw_is_that_which_was_packed) {
    add_ring();
    const GBuffer packed = inspect("newton");
    ASSERT_TRUE(renderer().load(pack(scene_)));
    RenderOptions options = all_parts();
    options.inspect = true;
    options.solver = find_solver("newton")->id;
    ASSERT_TRUE(renderer().draw(camera_, picture_size, options));
    const GBuffer chosen = renderer().read();
    EXPECT_EQ(chosen.depth_m, packed.depth_m);
    EXPECT_EQ(chosen.steps, packed.steps);
    EXPECT_NE(chosen.steps, inspect("sturm").steps);
}

TEST_F(InspectTest, translucent_parts_have_ids_where_a_draw_is_opaque) {
    scene_.materials = {{"glass", {0.8f, 0.0f, 0.0f, 0.5f}, 0}};
    add_ring();
    const auto seen = [&](bool opaque) {
        RenderOptions options = all_parts();
        options.opaque = opaque;
        EXPECT_TRUE(renderer().draw(camera_, picture_size, options));
        return renderer().read();
    };
    ASSERT_TRUE(renderer().load(pack(scene_)));
    const GBuffer opaque = seen(true);
    const GBuffer translucent = seen(false);
    PackOptions packing;
    packing.transparent_as_opaque = true;
    ASSERT_TRUE(renderer().load(pack(scene_, packing)));
    EXPECT_EQ(opaque.ids, seen(false).ids);
    EXPECT_EQ(std::count(translucent.ids.begin(), translucent.ids.end(), 0u), 0);
    EXPECT_GT(std::count(opaque.ids.begin(), opaque.ids.end(), 0u), 1000);
}

TEST_F(InspectTest, programs_are_prepared_one_at_a_time) {
    add_ring();
    ASSERT_TRUE(renderer().load(pack(scene_)));
    RenderOptions options = all_parts();
    options.solver = find_solver("double_derivative_bisection")->id;
    options.inspect = true;
    int compiled = 0;  // the three passes, if nobody needed them before
    for (Result<bool> ready = false; !ready.value(); ++compiled) {
        ready = renderer().prepare(options);
        ASSERT_TRUE(ready) << ready.error().message;
        ASSERT_LE(compiled, 3);
    }
    EXPECT_TRUE(renderer().prepare(options).value());
    EXPECT_TRUE(renderer().draw(camera_, picture_size, options));
    expect_no_gl_error();
}

}  // namespace
}  // namespace quartic
