// What counts as missed, false and elsewhere, and what as a tie.
#include "bench/judge.h"

#include "bench/scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace quartic {
namespace {

const f32::Torus ring{0.7f, 0.3f, 6.2831855f, 0.0f};

// A picture in which every ray, cast from near the ring, was answered rightly.
GBuffer right_picture(const View& view) {
    GBuffer picture;
    picture.size = view.size;
    const Crossings crossings = crossings_of(ring);
    for (int y = 0; y < view.size.height; ++y) {
        for (int x = 0; x < view.size.width; ++x) {
            const f64::Ray ray = pixel_ray(view, x + 0.5, y + 0.5);
            const glm::vec3 origin(ray.origin + 4.0 * ray.direction);
            const glm::vec3 direction(ray.direction);
            const RealRoots roots = crossings({LongVector(origin), LongVector(direction), -3.0L});
            picture.ray_origins.emplace_back(origin, -3.0f);
            picture.ray_directions.emplace_back(
                direction, roots.count > 0 ? static_cast<float>(roots.t[0]) : -1e18f);
            picture.rays.push_back(1);
            picture.steps.push_back(static_cast<std::uint16_t>(roots.count > 0 ? 3 : 1));
        }
    }
    return picture;
}

class JudgeTest : public testing::Test {
protected:
    View view_ = make_view(ring_camera(36.0), {96, 96});
    GBuffer picture_ = right_picture(view_);
    // A pixel in the middle of the tube's nearer side.
    std::size_t middle_ = find_middle();

    Judgement judge() const { return Judge(crossings_of(ring), view_, 0.3, 0.03).judge(picture_); }

private:
    std::size_t find_middle() const {
        std::size_t nearest = 0;
        for (std::size_t i = 0; i < picture_.ray_directions.size(); ++i) {
            const float t = picture_.ray_directions[i].w;
            const float best = picture_.ray_directions[nearest].w;
            nearest = t > -1e17f && (best < -1e17f || t < best) ? i : nearest;
        }
        return nearest;
    }
};

std::uint64_t wrong(const Judgement& judgement) {
    std::uint64_t sum = 0;
    for (const HardAndTie& kind : {judgement.missed, judgement.false_hits, judgement.elsewhere}) {
        sum += kind.hard + kind.tie;
    }
    return sum;
}

TEST_F(JudgeTest, right_answers_are_right) {
    const Judgement judgement = judge();
    EXPECT_EQ(wrong(judgement), 0u);
    EXPECT_EQ(judgement.covered, 96u * 96u);
    EXPECT_GT(judgement.hits, 2000u);
    EXPECT_EQ(judgement.errors.size(), judgement.hits);
    EXPECT_LT(*std::max_element(judgement.errors.begin(), judgement.errors.end()), 1e-6f);
    EXPECT_NEAR(judgement.waste(), 1.0 - static_cast<double>(judgement.hits) / (96.0 * 96.0),
                1e-12);
}

TEST_F(JudgeTest, hit_that_is_not_found_is_missed) {
    picture_.ray_directions[middle_].w = -1e18f;
    EXPECT_EQ(judge().missed.hard, 1u);
    EXPECT_EQ(wrong(judge()), 1u);
}

TEST_F(JudgeTest, hit_for_which_no_ray_was_cast_is_missed) {
    picture_.rays[middle_] = 0;
    EXPECT_EQ(judge().missed.hard, 1u);
}

TEST_F(JudgeTest, hit_in_a_corner_is_false) {
    picture_.ray_directions[0].w = 0.0f;
    EXPECT_EQ(judge().false_hits.hard, 1u);
    EXPECT_EQ(wrong(judge()), 1u);
}

TEST_F(JudgeTest, hit_far_from_the_true_one_is_elsewhere_and_near_it_is_an_error) {
    picture_.ray_directions[middle_].w += 0.04f;
    EXPECT_EQ(judge().elsewhere.hard, 1u);
    picture_.ray_directions[middle_].w -= 0.02f;
    const Judgement judgement = judge();
    EXPECT_EQ(wrong(judgement), 0u);
    EXPECT_NEAR(*std::max_element(judgement.errors.begin(), judgement.errors.end()), 0.02f / 0.3f,
                0.005f);
}

TEST_F(JudgeTest, answer_that_is_no_number_is_elsewhere) {
    picture_.ray_directions[middle_].w = std::nanf("");
    EXPECT_EQ(judge().elsewhere.hard, 1u);
}

TEST_F(JudgeTest, steps_are_counted_by_ray_and_by_block) {
    std::fill(picture_.steps.begin(), picture_.steps.end(), std::uint16_t{2});
    picture_.steps[0] = 10;  // one block of 32 pixels
    const Judgement judgement = judge();
    EXPECT_EQ(judgement.blocks, 96u * 96u / 32u);
    EXPECT_NEAR(judgement.steps_mean(), 2.0 + 8.0 / (96.0 * 96.0), 1e-12);
    EXPECT_NEAR(judgement.steps_mean_of_blocks(), 2.0 + 8.0 / 288.0, 1e-12);
    EXPECT_EQ(judgement.steps_max, 10u);
}

// One pixel whose ray passes so many pixels inside of the outermost circle, seen along the axis.
Judgement judge_silhouette(double inside_px, bool found) {
    Camera camera;
    camera.projection = Projection::orthographic;
    camera.height_m = 0.01;
    camera.target = {1.0 - 0.01 * inside_px, 0.0, 0.0};
    camera.eye = camera.target + glm::dvec3(0.0, 0.0, 5.0);
    camera.up = {0.0, 1.0, 0.0};
    const View view = make_view(camera, {1, 1});
    GBuffer picture = right_picture(view);
    if (!found) {
        picture.ray_directions[0].w = -1e18f;
    } else if (picture.ray_directions[0].w < -1e17f) {
        picture.ray_directions[0].w = 1.0f;
    }
    return Judge(crossings_of(ring), view, 0.3, 0.03).judge(picture);
}

TEST(Ties, rays_within_a_hundredth_of_a_pixel_of_the_silhouette_may_miss) {
    EXPECT_EQ(judge_silhouette(0.003, false).missed.tie, 1u);
    EXPECT_EQ(judge_silhouette(0.003, false).missed.hard, 0u);
    EXPECT_EQ(judge_silhouette(0.03, false).missed.hard, 1u);
    EXPECT_EQ(judge_silhouette(0.003, true).missed.hard, 0u);
}

TEST(Ties, rays_just_outside_may_hit) {
    EXPECT_EQ(judge_silhouette(-0.003, true).false_hits.tie, 1u);
    EXPECT_EQ(judge_silhouette(-0.03, true).false_hits.hard, 1u);
}

}  // namespace
}  // namespace quartic
