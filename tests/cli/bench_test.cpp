// The benchmarks on tiny pictures: the keys that scripts read, and every form of a report.
#include "tests/cli/run_program.h"
#include "tests/files/temporary_folder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <initializer_list>

namespace quartic {
namespace {

using nlohmann::json;

class BenchOfDrawing : public testing::Test {
protected:
    // The report of a run that also writes all of its other forms.
    json run(std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), "bench");
        for (const char* more : {"--size", "64", "--rounds", "1", "--json"}) {
            arguments.emplace_back(more);
        }
        for (const char* name : {"a.csv", "a.md", "a.txt"}) {
            arguments.insert(arguments.end(), {"-o", folder_.path(name)});
        }
        arguments.insert(arguments.end(), {"--plot", folder_.path("a.svg")});
        const Answer answer = run_quartic(arguments);
        EXPECT_EQ(answer.code, 0) << answer.err;
        const json report = json::parse(answer.out, nullptr, false);
        EXPECT_EQ(report["schema"], 1);
        EXPECT_EQ(report["bench"], arguments[1]);
        EXPECT_TRUE(report["renderer"].is_string());
        EXPECT_EQ(report["clock"], "wall");
        EXPECT_EQ(report["rounds"], 1);
        EXPECT_EQ(report["size"], json({64, 64}));
        EXPECT_FALSE(report["rows"].empty());
        expect_forms(report);
        return report;
    }

    // The first row of a method; of surfaces, that of all together at zoom 1.
    static json find_row(const json& report, const std::string& method) {
        for (const json& row : report["rows"]) {
            if (row["method"] == method && row.value("surface", "all") == "all") {
                return row;
            }
        }
        ADD_FAILURE() << "no row of " << method;
        return json::object();
    }

    // Of one round: how many times as fast as the base every method is.
    static void expect_ratios(const json& report, const std::string& base, const char* key) {
        const double base_ms = find_row(report, base)["frame_ms"];
        for (const json& row : report["rows"]) {
            if (row.value("count", 1) == 1 && row.value("surface", "all") == "all" &&
                row.value("zoom", 1.0) == 1.0) {
                const double expected = base_ms / row["frame_ms"].get<double>();
                EXPECT_NEAR(row[key], expected, 1e-9 * expected) << row["method"];
            }
        }
    }

    static void expect_keys(const json& row, std::initializer_list<const char*> keys) {
        for (const char* key : keys) {
            EXPECT_TRUE(row.contains(key)) << key;
        }
    }

    const TemporaryFolder folder_;

private:
    void expect_forms(const json& report) const {
        const std::string csv = read_bytes(folder_.path("a.csv"));
        EXPECT_EQ(count_lines(csv), report["rows"].size() + 1);
        const std::string renderer = report["renderer"];
        EXPECT_NE(csv.find(renderer), std::string::npos);
        for (const char* name : {"a.md", "a.txt", "a.svg"}) {
            EXPECT_NE(read_bytes(folder_.path(name)).find(renderer), std::string::npos) << name;
        }
        EXPECT_TRUE(read_bytes(folder_.path("a.md")).starts_with("# "));
        EXPECT_TRUE(read_bytes(folder_.path("a.svg")).starts_with("<?xml"));
    }
};

TEST_F(BenchOfDrawing, one_torus) {
    const json report = run({"one-torus"});
    const json newton = find_row(report, "newton");
    EXPECT_EQ(newton["fps"].size(), 6u);
    EXPECT_EQ(newton["waste"].size(), 6u);
    EXPECT_EQ(newton["bbox_pixels"].size(), 6u);
    EXPECT_EQ(newton["ratio_to_newton"], 1.0);
    expect_keys(newton, {"fps_mean",
                         "solver_only_ratio_to_newton",
                         "torus_pixels",
                         "missed_hard",
                         "missed",
                         "false_hard",
                         "false",
                         "wrong_lobe_hard",
                         "wrong_lobe",
                         "error_median",
                         "error_p9999",
                         "error_max",
                         "epsilon_r",
                         "epsilon_total",
                         "iterations_mean",
                         "iterations_block",
                         "iterations_max",
                         "megapixels_per_second",
                         "megapixels_stddev",
                         "megapixels_stddev_pct",
                         "gpu_bytes",
                         "paper_fps",
                         "paper_ratio_to_newton"});
    const json split = find_row(report, "convexity_split");
    EXPECT_EQ(split["missed_hard"], 0);
    EXPECT_EQ(split["false_hard"], 0);
    EXPECT_EQ(split["wrong_lobe_hard"], 0);
    EXPECT_LT(split["error_median"], 1e-6);
    EXPECT_NEAR(find_row(report, "polygon_64")["epsilon_total"], 0.001205, 1e-6);
    EXPECT_EQ(report["views"].size(), 6u);
}

TEST_F(BenchOfDrawing, many_tori) {
    const json report = run({"many-tori", "--count-max", "16"});
    EXPECT_EQ(report["rows"][0]["count"], 1);
    EXPECT_EQ(report["rows"].back()["count"], 16);
    expect_keys(report["rows"][0],
                {"method", "count", "frame_ms", "fps", "ratio_to_newton", "tori_per_second"});
    expect_ratios(report, "newton", "ratio_to_newton");
    EXPECT_EQ(report["crossovers"].size(), 12u);
}

TEST_F(BenchOfDrawing, cubics_and_quartics) {
    for (const char* name : {"cubics", "quartics"}) {
        const json report = run({name, "--views", "1"});
        const json sturm = find_row(report, "sturm");
        EXPECT_EQ(sturm["zoom"], 1.0);
        EXPECT_EQ(sturm["ratio_to_sturm"], 1.0);
        expect_ratios(report, "sturm", "ratio_to_sturm");
        EXPECT_GT(sturm["true_hits"], 0);
        expect_keys(sturm, {"surface", "frame_ms", "solver_only_ratio_to_sturm", "missed_hard",
                            "missed", "false_hard", "other_hard", "other", "wrong_hard",
                            "error_median", "error_p9999", "error_max", "iterations_mean"});
        EXPECT_EQ(report["rows"].back()["surface"], "all");
        EXPECT_EQ(report["rows"].back()["zoom"], 1e4);
    }
}

TEST_F(BenchOfDrawing, solvers_of_a_model) {
    const std::string model = folder_.path("elbows.rvm");
    ASSERT_EQ(run_quartic({"generate", "elbows", "--count", "20", "-o", model}).code, 0);
    const json report = run({"solvers", model, "--views", "2"});
    const json split = find_row(report, "convexity_split");
    EXPECT_EQ(split["ratio_to_convexity_split"], 1.0);
    expect_ratios(report, "convexity_split", "ratio_to_convexity_split");
    EXPECT_GT(split["hit_pixels"], 100);
    for (const char* key : {"missed_hard", "false_hard", "wrong_id_hard", "nan_pixels"}) {
        EXPECT_EQ(split[key], 0) << key;
    }
    expect_keys(find_row(report, "newton"),
                {"file", "frame_ms", "solver_only_ratio_to_convexity_split", "missed", "wrong_id",
                 "depth_error_p9999", "normal_error_deg_max"});
}

TEST_F(BenchOfDrawing, proxies) {
    const json report = run({"proxies", "--views", "2"});
    ASSERT_EQ(report["rows"].size(), 13u * 4u);
    for (std::size_t i = 0; i < report["rows"].size(); i += 4) {
        const json& box = report["rows"][i];
        const json& quad = report["rows"][i + 1];
        const json& hull = report["rows"][i + 2];
        const std::string shape = box["shape"];
        EXPECT_EQ(box["proxy"], "box");
        EXPECT_EQ(hull["proxy"], "hull");
        EXPECT_GT(box["compared_pixels"], 100) << shape;
        EXPECT_GT(hull["waste"], 0.0) << shape;
        EXPECT_LT(hull["waste"], box["waste"]) << shape;
        for (const json& row : {quad, hull}) {
            EXPECT_EQ(row["lost"], 0) << shape;
            EXPECT_EQ(row["gained"], 0) << shape;
        }
    }
    // 8, 16 and 32 pixels, of each shape and of all; all are small, for which there are quads.
    ASSERT_EQ(report["times"].size(), 14u * 3u);
    const json& time = report["times"][0];
    expect_keys(time,
                {"shape", "size_px", "seen_px", "fastest", "fastest_ratio_to_automatic", "right"});
    EXPECT_EQ(time["frame_ms"].size(), 4u);
    EXPECT_EQ(time["chosen"], "quad");
    EXPECT_EQ(report["crossovers"].size(), 14u);
}

TEST(BenchUsage, solvers_need_a_model) {
    const Answer run = run_quartic({"bench", "solvers"});
    EXPECT_EQ(run.code, 2);
    EXPECT_NE(run.err.find("expected a model"), std::string::npos) << run.err;
}

TEST(BenchUsage, report_of_no_known_form_is_refused_before_anything_is_measured) {
    const Answer run = run_quartic({"bench", "one-torus", "-o", "a.pdf"});
    EXPECT_EQ(run.code, 2);
    EXPECT_NE(run.err.find(".svg"), std::string::npos) << run.err;
}

TEST(BenchUsage, help_lists_the_benchmarks) {
    const Answer run = run_quartic({"bench", "--help"});
    for (const char* name :
         {"load", "one-torus", "many-tori", "cubics", "quartics", "solvers", "proxies"}) {
        EXPECT_NE(run.out.find(name), std::string::npos) << name;
    }
}

}  // namespace
}  // namespace quartic
