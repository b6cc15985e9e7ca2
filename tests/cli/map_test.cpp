// Maps that render draws: their figures, and what they refuse.
#include "exporters/save.h"
#include "scene/add_shape.h"
#include "tests/cli/run_program.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdio>
#include <numbers>

namespace quartic {
namespace {

using nlohmann::json;

// The torus of de Toledo, Levy, Paul 2007, table 1, from 72 degrees: where printed Newton loses
// much.
class Maps : public testing::Test {
protected:
    void SetUp() override {
        Scene scene;
        scene.nodes.push_back({});
        scene.kinds = {"torus"};
        scene.materials = {{"grey", {0.5f, 0.5f, 0.5f, 1.0f}, 0}};
        add_shape(scene, f64::Torus{0.7, 0.3, 2.0 * std::numbers::pi, 0.0}, {});
        model_ = folder_.path("torus.rvm");
        ASSERT_TRUE(save_scene(scene, model_));
    }

    static std::string camera() {
        const double angle = 72.0 * std::numbers::pi / 180.0;
        char text[96];
        std::snprintf(text, sizeof(text), "%.9f,0,%.9f;0,0,0;0,0,1", 5.579 * std::sin(angle),
                      5.579 * std::cos(angle));
        return text;
    }

    json map(const std::string& kind, const std::string& solver,
             const std::vector<std::string>& options = {}) {
        picture_ = folder_.path(kind + "-" + solver + ".png");
        std::vector<std::string> arguments{"render", model_,     "-o",     picture_,   "--size",
                                           "200",    "--camera", camera(), "--fov",    "30",
                                           "--json", "--map",    kind,     "--solver", solver};
        arguments.insert(arguments.end(), options.begin(), options.end());
        const Answer run = run_quartic(arguments);
        EXPECT_EQ(run.code, 0) << run.err;
        const json document = json::parse(run.out, nullptr, false);
        EXPECT_FALSE(document.is_discarded()) << run.out;
        EXPECT_EQ(document["map"], kind);
        return document;
    }

    TemporaryFolder folder_;
    std::string model_;
    std::string picture_;
};

TEST_F(Maps, error_counts_what_newton_misses_and_convexity_split_does_not) {
    const json newton = map("error", "newton");
    EXPECT_GT(newton["map_counts"]["missed"], 50);
    EXPECT_EQ(newton["map_counts"]["false"], 0);
    const json split = map("error", "convexity_split");
    EXPECT_EQ(split["map_counts"]["missed"], 0);
    EXPECT_EQ(split["map_counts"]["false"], 0);
    EXPECT_EQ(split["map_counts"]["wrong_part"], 0);
    EXPECT_EQ(split["map_unit"], "m");
    EXPECT_LT(split["map_max"], 1e-4);
    EXPECT_LE(split["map_min"], split["map_mean"]);
    EXPECT_LE(split["map_p99"], split["map_max"]);
}

TEST_F(Maps, difference_counts_hits_of_one_solver_alone) {
    const json lost = map("difference", "newton");
    EXPECT_EQ(lost["map_counts"]["only_first"], 0);
    EXPECT_EQ(lost["map_counts"]["only_second"], map("error", "newton")["map_counts"]["missed"]);
    const json same = map("difference", "sturm", {"--against", "sturm"});
    EXPECT_EQ(same["map_max"], 0.0);
    EXPECT_EQ(same["map_counts"]["only_second"], 0);
}

TEST_F(Maps, solver_counts_the_pixels_of_each) {
    const json document = map("solver", "newton", {"--split", "sturm"});
    EXPECT_GT(document["map_counts"]["newton"], 100);
    EXPECT_GT(document["map_counts"]["sturm"], 100);
    EXPECT_EQ(document["map_counts"]["analytic"], 0);
}

TEST_F(Maps, steps_are_those_of_every_ray) {
    const json rays = map("rays", "sturm");
    const json steps = map("steps", "sturm");
    EXPECT_EQ(steps["map_pixels"], rays["map_pixels"]);
    EXPECT_GE(rays["map_min"], 1);
    // Sturm halves 20 times (solvers/sturm.glsl).
    EXPECT_LE(steps["map_max"], 20 * rays["map_max"].get<int>());
    EXPECT_GE(steps["map_max"], 20);
}

TEST_F(Maps, a_split_picture_is_the_left_of_one_and_the_right_of_the_other) {
    const auto draw = [&](const std::string& name, const std::vector<std::string>& options) {
        std::vector<std::string> arguments{"render", model_,    "-o",       folder_.path(name),
                                           "--size", "200x100", "--camera", camera()};
        arguments.insert(arguments.end(), options.begin(), options.end());
        const Answer run = run_quartic(arguments);
        EXPECT_EQ(run.code, 0) << run.err;
        return read_bytes(folder_.path(name));
    };
    const std::string whole = draw("a.png", {"--solver", "sturm"});
    const std::string split = draw("b.png", {"--solver", "sturm", "--split", "newton"});
    EXPECT_TRUE(split.starts_with("\x89PNG"));
    EXPECT_NE(whole, split);
}

TEST_F(Maps, what_makes_no_sense_is_refused) {
    const std::vector<std::vector<std::string>> wrong{
        {"--map", "beauty"},
        {"--map", "error", "--device", "reference"},
        {"--map", "error", "--samples", "4"},
        {"--map", "steps", "--frames", "10"},
        {"--map", "difference", "--split", "sturm"},
        {"--split", "no_such_solver"},
    };
    for (const std::vector<std::string>& options : wrong) {
        std::vector<std::string> arguments{"render", model_, "-o", folder_.path("a.png")};
        arguments.insert(arguments.end(), options.begin(), options.end());
        EXPECT_EQ(run_quartic(arguments).code, 2) << options[1];
    }
}

}  // namespace
}  // namespace quartic
