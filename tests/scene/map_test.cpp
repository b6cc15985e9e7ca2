// Maps of pictures: which pixel gets which number, class and colour.
#include "scene/map.h"

#include "scene/add_shape.h"
#include "scene/map_picture.h"
#include "solvers/solver_table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace quartic {
namespace {

constexpr float far_away = std::numeric_limits<float>::infinity();

// A sphere seen from 5 m, in a picture of its own rays in double.
class MapTest : public testing::Test {
protected:
    MapTest() {
        scene_.nodes.push_back({});
        scene_.kinds = {"sphere"};
        scene_.materials = {{"plain", {0.5f, 0.5f, 0.5f, 1.0f}, 0},
                            {"halved", {0.5f, 0.5f, 0.5f, 1.0f}, find_solver("sturm")->id}};
        Camera camera;
        camera.eye = {0.0, -5.0, 0.0};
        camera.target = {0.0, 0.0, 0.0};
        view_ = make_view(camera, {40, 30});
    }

    void add(auto shape, std::uint32_t material = 0) {
        Part part;
        part.material = material;
        add_shape(scene_, shape, part);
    }

    void take_picture() {
        const Reference reference(scene_, {true, true, true, true});
        ids_.assign(pixel_count(view_.size), no_index);
        depths_.assign(ids_.size(), far_away);
        normals_.assign(ids_.size(), glm::vec3(0.0f));
        for (int y = 0; y < view_.size.height; ++y) {
            for (int x = 0; x < view_.size.width; ++x) {
                const ReferenceHit hit = reference.trace(pixel_ray(view_, x + 0.5, y + 0.5));
                if (hit.part != no_index) {
                    const std::size_t at = pixel_index(view_.size, x, y);
                    ids_[at] = hit.part;
                    depths_[at] = static_cast<float>(hit.t);
                    normals_[at] = glm::vec3(hit.normal);
                }
            }
        }
    }

    Picture picture() const { return {view_.size, ids_, depths_, normals_}; }
    std::size_t middle() const { return pixel_index(view_.size, 20, 15); }

    Map error() const {
        const Reference reference(scene_, {true, true, true, true}, solver_default);
        return error_map(reference, view_, picture());
    }

    Scene scene_;
    View view_;
    std::vector<std::uint32_t> ids_;
    std::vector<float> depths_;
    std::vector<glm::vec3> normals_;
};

std::uint64_t count_of(const Map& map, std::string_view name) {
    for (const MapClass& one : map.class_list) {
        if (one.name == name) {
            return one.count;
        }
    }
    ADD_FAILURE() << "no class is called " << name;
    return 0;
}

TEST(ColourMap, grows_lighter_from_violet_to_yellow) {
    EXPECT_EQ(heat_colour(0.0), (Rgb{68, 1, 84}));
    EXPECT_EQ(heat_colour(-3.0), heat_colour(0.0));
    EXPECT_EQ(heat_colour(1.0), (Rgb{253, 231, 37}));
    EXPECT_EQ(heat_colour(7.0), heat_colour(1.0));
    double last = -1.0;
    for (int i = 0; i <= 100; ++i) {
        const Rgb colour = heat_colour(0.01 * i);
        const double light = 0.2126 * colour.red + 0.7152 * colour.green + 0.0722 * colour.blue;
        EXPECT_GT(light, last) << i;
        last = light;
    }
    EXPECT_TRUE(is_dark(heat_colour(0.0)));
    EXPECT_FALSE(is_dark(heat_colour(1.0)));
}

TEST(ColourMap, kinds_differ_from_one_another) {
    for (std::size_t i = 0; i < kind_colours; ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            EXPECT_FALSE(kind_colour(i) == kind_colour(j)) << i << " and " << j;
        }
    }
}

TEST(Maps, are_found_by_their_names) {
    for (const MapRow& row : map_table()) {
        EXPECT_EQ(find_map(row.name), row.kind);
        EXPECT_EQ(row_of(row.kind).name, row.name);
    }
    EXPECT_FALSE(find_map("beauty"));
}

TEST(Maps, counts_are_numbers_only_where_rays_were_solved) {
    const std::vector<std::uint16_t> steps{0, 0, 18, 36};
    const std::vector<std::uint16_t> rays{0, 1, 1, 2};
    const Map map = count_map(MapKind::steps, {2, 2}, steps, rays);
    EXPECT_TRUE(std::isnan(map.values[0]));
    EXPECT_EQ(map.values[1], 0.0f);
    EXPECT_EQ(map.values[3], 36.0f);
    const MapFigures figures = figures_of(map);
    EXPECT_EQ(figures.count, 3u);
    EXPECT_EQ(figures.min, 0.0);
    EXPECT_EQ(figures.mean, 18.0);
    EXPECT_EQ(figures.max, 36.0);
    EXPECT_EQ(figures.p99, 36.0);
}

TEST(Maps, a_scale_of_counts_ends_where_99_of_100_pixels_are) {
    std::vector<std::uint16_t> steps(1000, 18);
    steps[7] = 500;
    const std::vector<std::uint16_t> rays(1000, 1);
    const Map map = count_map(MapKind::steps, {100, 10}, steps, rays);
    const MapScale scale = scale_of(map);
    EXPECT_EQ(scale.high, 18.0);
    EXPECT_EQ(place_on(scale, 9.0), 0.5);
    EXPECT_EQ(place_on(scale, 500.0), 1.0);
    EXPECT_EQ(legend_of(map, scale).ticks.back().text, "18+");
}

TEST_F(MapTest, a_true_picture_errs_by_less_than_a_float_step) {
    add(f64::Sphere{1.0, 0, 0, 0});
    take_picture();
    const Map map = error();
    EXPECT_LT(figures_of(map).max, 1e-6);
    EXPECT_GT(figures_of(map).count, 100u);
    for (const MapClass& one : map.class_list) {
        EXPECT_EQ(one.count, 0u) << one.name;
    }
}

TEST_F(MapTest, an_error_is_metres_along_the_ray) {
    add(f64::Sphere{1.0, 0, 0, 0});
    take_picture();
    const std::size_t at = pixel_index(view_.size, 22, 18);
    depths_[at] += 0.01f;
    const double along = glm::length(pixel_ray(view_, 22.5, 18.5).direction);
    EXPECT_NEAR(static_cast<double>(error().values[at]), 0.01 * along, 1e-6);
}

TEST_F(MapTest, lost_false_and_wrong_pixels_have_classes_of_their_own) {
    add(f64::Sphere{1.0, 0, 0, 0});
    take_picture();
    ids_[middle()] = no_index;
    ids_[0] = 0;
    depths_[0] = 4.0f;
    add(f64::Sphere{0.1, 0, 0, 0});
    ids_[middle() + 1] = 1;
    const Map map = error();
    EXPECT_EQ(count_of(map, "missed"), 1u);
    EXPECT_EQ(count_of(map, "false"), 1u);
    EXPECT_EQ(count_of(map, "wrong_part"), 1u);
    EXPECT_TRUE(std::isnan(map.values[middle()]));
    const std::vector<std::uint8_t> rgba = colours_of(map, scale_of(map));
    const Rgb shown{rgba[4 * middle()], rgba[4 * middle() + 1], rgba[4 * middle() + 2]};
    EXPECT_EQ(shown, map.class_list[0].colour);
    EXPECT_EQ(legend_of(map, scale_of(map)).lines[0].text, "missed: 1");
}

TEST_F(MapTest, a_stopped_error_map_has_no_rows) {
    add(f64::Sphere{1.0, 0, 0, 0});
    take_picture();
    const Reference reference(scene_, {true, true, true, true}, solver_default);
    const Map map = error_map(reference, view_, picture(), [] { return true; });
    EXPECT_EQ(figures_of(map).count, 0u);
}

TEST_F(MapTest, solvers_are_named_where_a_shape_has_a_choice) {
    add(f64::Torus{1.0, 0.3, 6.28, 0}, 1);
    take_picture();
    EXPECT_GT(count_of(solver_map(scene_, picture(), 0), "sturm"), 50u);
    EXPECT_EQ(count_of(solver_map(scene_, picture(), 0), "newton"), 0u);
    EXPECT_GT(count_of(solver_map(scene_, picture(), find_solver("newton")->id), "newton"), 50u);
    add(f64::Sphere{1.5, 0, 0, 0}, 1);
    take_picture();
    EXPECT_GT(count_of(solver_map(scene_, picture(), 0), "closed_form"), 50u);
}

TEST_F(MapTest, a_difference_says_which_picture_hits_alone) {
    add(f64::Sphere{1.0, 0, 0, 0});
    take_picture();
    const std::vector<std::uint32_t> ids = ids_;
    const std::vector<float> depths = depths_;
    const Picture first{view_.size, ids, depths, normals_};
    ids_[middle()] = no_index;
    ids_[0] = 0;
    depths_[middle() + 1] += 0.5f;
    const Map map = difference_map(view_, {first, "sturm"}, {picture(), "newton"});
    EXPECT_EQ(count_of(map, "only_first"), 1u);
    EXPECT_EQ(count_of(map, "only_second"), 1u);
    EXPECT_NEAR(figures_of(map).max, 0.5, 1e-2);
    const MapScale scale = scale_of(map);
    EXPECT_NEAR(scale.high, 1.0, 1e-12);
    EXPECT_NEAR(place_on(scale, scale.low), 0.0, 1e-12);
    EXPECT_EQ(legend_of(map, scale).lines[0].text, "only sturm: 1");
}

TEST_F(MapTest, a_split_map_is_the_second_from_the_divider_on) {
    const std::vector<std::uint16_t> rays(8, 1);
    const Map left = count_map(MapKind::rays, {4, 2}, rays, rays);
    const std::vector<std::uint16_t> twice(8, 2);
    const Map right = count_map(MapKind::rays, {4, 2}, twice, twice);
    const Map map = split_maps(left, right, 3);
    EXPECT_EQ(map.values, (std::vector<float>{1, 1, 1, 2, 1, 1, 1, 2}));
}

}  // namespace
}  // namespace quartic
