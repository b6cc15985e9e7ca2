// Every primitive with every awkward parameter, pixel by pixel against the double reference.
#include "generators/generate.h"
#include "scene/joints.h"
#include "tests/gpu/gpu_fixture.h"

#include <memory>

namespace quartic {
namespace {

constexpr PixelSize picture_size{512, 512};

class SheetTest : public GpuTest {
protected:
    // Generated once: the tests only look at it.
    static const Scene& sheet() {
        static const Scene scene = [] {
            Result<Scene> made = generate("sheet", {});
            EXPECT_TRUE(made);
            find_joints(made.value());
            return std::move(made).value();
        }();
        return scene;
    }

    void check(const Scene& scene, std::span<const Camera> cameras) {
        load(scene);
        const Reference reference(scene, all_layers);
        Comparison comparison;
        std::uint64_t nan_pixels = 0;
        for (const Camera& camera : cameras) {
            const GBuffer picture = draw(camera, picture_size);
            nan_pixels += picture.nan_pixels;
            compare(reference, make_view(camera, picture_size), picture_of(picture), comparison);
        }
        for (const WrongPixel& pixel : comparison.wrong_pixels) {
            ADD_FAILURE() << "view " << pixel.view << ", pixel " << pixel.x << ',' << pixel.y
                          << ": part " << pixel.seen << " at " << pixel.seen_depth_m
                          << " m instead of " << pixel.truth << " at " << pixel.true_depth_m;
        }
        EXPECT_GT(comparison.hit_pixels, 10000u);
        EXPECT_EQ(comparison.missed.hard, 0u);
        EXPECT_EQ(comparison.false_hits.hard, 0u);
        EXPECT_EQ(comparison.wrong_id.hard, 0u);
        EXPECT_EQ(nan_pixels, 0u);
        EXPECT_LE(figures(comparison.depth_errors).p9999, 1e-5);
        EXPECT_LE(figures(comparison.normal_errors_deg).p9999, 0.1);
        expect_no_gl_error();
    }

    static std::vector<Camera> cameras_around(const Box3& box, Projection projection, int count) {
        std::vector<Camera> cameras;
        Camera like;
        like.projection = projection;
        for (int i = 0; i < count; ++i) {
            cameras.push_back(
                fit_camera(box, spread_direction(i, count), {0, 0, 1}, like, picture_size));
        }
        return cameras;
    }
};

TEST_F(SheetTest, perspective_views_from_all_sides_have_no_wrong_pixel) {
    check(sheet(), cameras_around(world_bounds(sheet(), all_layers), Projection::perspective, 12));
}

TEST_F(SheetTest, orthographic_views_from_all_sides_have_no_wrong_pixel) {
    check(sheet(), cameras_around(world_bounds(sheet(), all_layers), Projection::orthographic, 12));
}

TEST_F(SheetTest, close_views_of_each_part_have_no_wrong_pixel) {
    std::vector<Camera> cameras;
    for (std::size_t i = 0; i < sheet().parts.size(); i += 2) {
        Camera like;
        like.projection = i % 4 == 0 ? Projection::perspective : Projection::orthographic;
        cameras.push_back(fit_camera(
            world_bounds(sheet(), sheet().parts[i]),
            spread_direction(static_cast<int>(i), static_cast<int>(sheet().parts.size())),
            {0, 0, 1}, like, picture_size));
    }
    check(sheet(), cameras);
}

TEST_F(SheetTest, views_from_inside_each_part_have_no_wrong_pixel) {
    std::vector<Camera> cameras;
    for (std::size_t i = 1; i < sheet().parts.size(); i += 2) {
        const Box3 box = world_bounds(sheet(), sheet().parts[i]);
        Camera camera;
        camera.fov_y = 1.2;
        camera.eye = 0.5 * (box.low + box.high) + 0.05 * (box.high - box.low);
        camera.target = camera.eye + spread_direction(static_cast<int>(i),
                                                      static_cast<int>(sheet().parts.size()));
        camera.near_m = 1e-3;
        cameras.push_back(camera);
    }
    check(sheet(), cameras);
}

TEST_F(SheetTest, near_plane_cutting_parts_leaves_no_wrong_pixel) {
    std::vector<Camera> cameras;
    for (std::size_t i = 0; i < sheet().parts.size(); i += 3) {
        const Box3 box = world_bounds(sheet(), sheet().parts[i]);
        Camera like;
        like.projection = i % 2 == 0 ? Projection::perspective : Projection::orthographic;
        Camera camera = fit_camera(
            box, spread_direction(static_cast<int>(i), static_cast<int>(sheet().parts.size())),
            {0, 0, 1}, like, picture_size);
        camera.near_m = glm::distance(camera.eye, 0.5 * (box.low + box.high));
        cameras.push_back(camera);
    }
    check(sheet(), cameras);
}

TEST_F(SheetTest, moved_by_ten_million_metres_gives_the_same_picture) {
    const glm::dvec3 offset(1e7, -1e7, 1e7);
    auto moved = std::make_unique<Scene>(sheet());
    for (Part& part : moved->parts) {
        part.placement.position += offset;
    }
    const std::vector<Camera> cameras =
        cameras_around(world_bounds(sheet(), all_layers), Projection::perspective, 6);
    std::vector<GBuffer> pictures;
    load(sheet());
    for (const Camera& camera : cameras) {
        pictures.push_back(draw(camera, picture_size));
    }
    load(*moved);
    for (std::size_t i = 0; i < cameras.size(); ++i) {
        Camera camera = cameras[i];
        camera.eye += offset;
        camera.target += offset;
        const GBuffer picture = draw(camera, picture_size);
        int different = 0;
        for (std::size_t k = 0; k < picture.colours.size(); ++k) {
            different += std::abs(static_cast<int>(picture.colours[k]) -
                                  static_cast<int>(pictures[i].colours[k])) > 1;
        }
        EXPECT_EQ(different, 0) << "view " << i;
    }
    expect_no_gl_error();
}

}  // namespace
}  // namespace quartic
