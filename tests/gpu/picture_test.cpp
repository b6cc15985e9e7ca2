// What a frame promises: culling changes nothing, layers hide, picking finds, translucent parts
// show what is behind.
#include "scene/add_shape.h"
#include "solvers/solver_table.h"
#include "tests/gpu/gpu_fixture.h"

#include <cmath>

namespace quartic {
namespace {

constexpr PixelSize picture_size{320, 240};

class PictureTest : public GpuTest {
protected:
    PictureTest() {
        scene_.nodes.push_back({});
        scene_.kinds = {"cylinder"};
        scene_.materials = {{"grey", {0.5f, 0.5f, 0.5f, 1.0f}, 0},
                            {"red glass", {0.8f, 0.0f, 0.0f, 0.5f}, 0}};
    }

    Part at(double x, double y, double z) const {
        Part part;
        part.placement.position = {x, y, z};
        return part;
    }

    Scene scene_;
};

TEST_F(PictureTest, frustum_culling_changes_no_pixel) {
    for (int i = 0; i < 400; ++i) {
        const glm::dvec3 p = 6.0 * spread_direction(i, 400) * (1.0 + (i % 7));
        add_shape(scene_, f64::Cylinder{0.2, 2.0, 0, 0}, at(p.x, p.y, p.z));
        add_shape(scene_, f64::Torus{0.5, 0.1, 2.0, 0}, at(p.y, p.z, p.x));
    }
    load(scene_);
    for (int view = 0; view < 8; ++view) {
        Camera camera;
        camera.projection = view % 2 == 0 ? Projection::perspective : Projection::orthographic;
        camera.eye = 3.0 * spread_direction(view, 8);
        camera.target = camera.eye + spread_direction(7 - view, 8);
        camera.height_m = 8.0;
        RenderOptions options = all_parts();
        ASSERT_TRUE(renderer().draw(camera, picture_size, options));
        const FrameCounts counts = renderer().counts();
        EXPECT_GT(counts.culled_by_frustum, 100u);
        EXPECT_EQ(counts.drawn + counts.culled_by_frustum, 800u);
        const GBuffer culled = renderer().read();
        options.cull_frustum = false;
        ASSERT_TRUE(renderer().draw(camera, picture_size, options));
        const GBuffer all = renderer().read();
        EXPECT_EQ(culled.depth_m, all.depth_m) << "view " << view;
    }
    expect_no_gl_error();
}

TEST_F(PictureTest, hidden_layers_are_not_drawn) {
    Part line = at(0, 0, 0);
    line.layer = Layer::line;
    add_shape(scene_, f64::Sphere{1.0, 0, 0, 0}, line);
    load(scene_);
    Camera camera;
    RenderOptions options = all_parts();
    options.layers = {true, true, true, false};
    ASSERT_TRUE(renderer().draw(camera, picture_size, options));
    EXPECT_EQ(renderer().part_at(160, 120), no_index);
    ASSERT_TRUE(renderer().draw(camera, picture_size, all_parts()));
    EXPECT_EQ(renderer().part_at(160, 120), 0u);
}

TEST_F(PictureTest, picking_gives_part_and_depth) {
    add_shape(scene_, f64::Sphere{1.0, 0, 0, 0}, at(50, 0, 0));
    add_shape(scene_, f64::Sphere{1.0, 0, 0, 0}, at(0, 0, 0));
    load(scene_);
    Camera camera;  // at y = -10, looking along y
    ASSERT_TRUE(renderer().draw(camera, picture_size, all_parts()));
    EXPECT_EQ(renderer().part_at(160, 120), 1u);
    ASSERT_TRUE(renderer().depth_at(160, 120));
    EXPECT_NEAR(*renderer().depth_at(160, 120), 9.0, 1e-3);
    EXPECT_EQ(renderer().part_at(5, 5), no_index);
    EXPECT_FALSE(renderer().depth_at(5, 5));
    EXPECT_EQ(renderer().part_at(-1, 5000), no_index);
}

TEST_F(PictureTest, translucent_parts_tint_what_is_behind_and_have_no_id) {
    add_shape(scene_, f64::Sphere{1.0, 0, 0, 0}, at(0, 0, 0));
    Part glass = at(0, -3, 0);
    glass.material = 1;
    add_shape(scene_, f64::Cylinder{0.5, 2.0, 0, 0}, glass);
    ASSERT_TRUE(renderer().load(pack(scene_)));
    Camera camera;
    ASSERT_TRUE(renderer().draw(camera, picture_size, all_parts()));
    const GBuffer picture = renderer().read();
    const std::size_t middle = 120 * 320 + 160;
    EXPECT_EQ(picture.ids[middle], 0u);
    EXPECT_GT(picture.colours[4 * middle], picture.colours[4 * middle + 1] + 30);
}

TEST_F(PictureTest, two_solvers_share_one_picture) {
    const SolverRow* const newton = find_solver("newton");
    const SolverRow* const sturm = find_solver("sturm");
    ASSERT_TRUE(newton != nullptr && sturm != nullptr);
    scene_.materials = {{"one", {0.5f, 0.5f, 0.5f, 1.0f}, newton->id},
                        {"two", {0.5f, 0.5f, 0.5f, 1.0f}, sturm->id}};
    for (int i = 0; i < 16; ++i) {
        Part part = at(1.5 * (i % 4) - 2.25, 0.0, 1.5 * (i / 4) - 2.25);
        part.material = static_cast<std::uint32_t>(i % 2);
        part.placement.rotation = glm::dquat(std::cos(0.6), std::sin(0.6), 0.0, 0.0);
        add_shape(scene_, f64::Torus{0.5, 0.15, 1.5707963267948966, 0.0}, part);
    }
    PackOptions packing;
    const Packed packed = pack(scene_, packing);
    ASSERT_EQ(packed.batches.size(), 2u);
    EXPECT_NE(packed.batches[0].solver, packed.batches[1].solver);
    ASSERT_TRUE(renderer().load(packed));
    const GBuffer mixed = draw(Camera(), picture_size);
    packing.solver = solver_default;
    ASSERT_TRUE(renderer().load(pack(scene_, packing)));
    const GBuffer plain = draw(Camera(), picture_size);
    int hits = 0;
    int different = 0;
    for (std::size_t i = 0; i < plain.ids.size(); ++i) {
        hits += plain.ids[i] != no_index;
        different += plain.ids[i] != mixed.ids[i];
    }
    EXPECT_GT(hits, 3000);
    EXPECT_LT(different, hits / 50);  // Newton as printed loses about one in a hundred
    expect_no_gl_error();
}

TEST_F(PictureTest, small_parts_are_culled_by_their_size_only_when_asked) {
    add_shape(scene_, f64::Sphere{0.001, 0, 0, 0}, at(0, 0, 0));
    load(scene_);
    Camera camera;
    RenderOptions options = all_parts();
    options.cull_size = true;
    options.size_min_px = 0.3;
    ASSERT_TRUE(renderer().draw(camera, picture_size, options));
    EXPECT_EQ(renderer().counts().culled_by_size, 1u);
    ASSERT_TRUE(renderer().draw(camera, picture_size, all_parts()));
    EXPECT_EQ(renderer().counts().drawn, 1u);
}

TEST_F(PictureTest, an_empty_scene_is_background) {
    load(scene_);
    const GBuffer picture = draw(Camera(), picture_size);
    for (const std::uint32_t id : picture.ids) {
        ASSERT_EQ(id, no_index);
    }
    expect_no_gl_error();
}

TEST_F(PictureTest, sizes_outside_the_limits_are_refused) {
    load(scene_);
    EXPECT_FALSE(renderer().draw(Camera(), {0, 10}, all_parts()));
    EXPECT_FALSE(renderer().draw(Camera(), {10, 20000}, all_parts()));
}

}  // namespace
}  // namespace quartic
