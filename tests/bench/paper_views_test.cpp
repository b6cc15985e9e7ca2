// The six views of de Toledo, Levy, Paul 2007, table 1, drawn on the GPU at the paper's size: the
// benchmark draws what the paper drew.
#include "bench/judge.h"
#include "bench/paper_table.h"
#include "bench/scenes.h"
#include "bench/stage.h"
#include "solvers/solver_table.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <optional>

namespace quartic {
namespace {

constexpr PixelSize paper_size{1024, 1024};

class PaperViews : public testing::Test {
protected:
    void SetUp() override {
        Result<Stage> stage = Stage::open(false);
        if (!stage) {
            std::fprintf(stderr, "SKIPPED: %s\n", stage.error().message.c_str());
            GTEST_SKIP() << "no usable OpenGL";
        }
        stage_.emplace(std::move(stage).value());
    }

    Judgement judge(std::size_t view, const char* solver, Proxy proxy) {
        FrameCase frame;
        frame.packed = pack_for(ring_scene(), find_solver(solver)->id);
        frame.camera = ring_camera(paper_angles_deg[view]);
        frame.size = paper_size;
        frame.options = bench_options();
        frame.options.proxy = proxy;
        const Result<GBuffer> picture = stage_->inspect(frame);
        EXPECT_TRUE(picture);
        Judge judge(crossings_of(float_ring()), make_view(frame.camera, frame.size),
                    test_ring.radius, 0.1 * test_ring.radius);
        return picture ? judge.judge(picture.value()) : Judgement();
    }

    std::optional<Stage> stage_;
};

TEST_F(PaperViews, waste_of_the_box_is_the_papers_within_half_a_point) {
    for (std::size_t view = 0; view < paper_angles_deg.size(); ++view) {
        const Judgement box = judge(view, "newton", Proxy::box);
        EXPECT_NEAR(100.0 * box.waste(), paper_waste_pct[view], 0.5) << paper_angles_deg[view];
        EXPECT_NEAR(1e-3 * static_cast<double>(box.covered), paper_box_kilopixels[view], 5.0);
        EXPECT_NEAR(1e-3 * static_cast<double>(box.hits), paper_torus_kilopixels[view], 3.0);
    }
}

TEST_F(PaperViews, default_solver_is_right_everywhere_on_either_proxy) {
    for (const Proxy proxy : {Proxy::box, Proxy::automatic}) {
        for (const std::size_t view : {0u, 4u}) {
            const Judgement judgement = judge(view, "convexity_split", proxy);
            EXPECT_EQ(judgement.missed.hard, 0u);
            EXPECT_EQ(judgement.false_hits.hard, 0u);
            EXPECT_EQ(judgement.elsewhere.hard, 0u);
            EXPECT_GT(judgement.hits, 200000u);
            EXPECT_GT(judgement.steps_max, 0u);
        }
    }
}

TEST_F(PaperViews, newton_as_printed_loses_hits_at_72_degrees) {
    EXPECT_GT(judge(4, "newton", Proxy::box).missed.hard, 5000u);
    EXPECT_EQ(judge(0, "newton", Proxy::box).missed.hard, 0u);
}

}  // namespace
}  // namespace quartic
