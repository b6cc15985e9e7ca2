// What scripts read: JSON on standard output, pictures, and counts that must agree.
#include "tests/cli/run_program.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace quartic {
namespace {

using nlohmann::json;

// A model of the generator's, in a folder of its own.
class Data : public testing::Test {
protected:
    std::string generate(const std::string& kind, const std::vector<std::string>& options = {}) {
        std::vector<std::string> arguments{"generate", kind, "-o", folder_.path(kind + ".rvm")};
        arguments.insert(arguments.end(), options.begin(), options.end());
        const Answer run = run_quartic(arguments);
        EXPECT_EQ(run.code, 0) << run.err;
        return arguments[3];
    }

    // Standard output must be one JSON document and nothing else.
    static json run_for_json(std::vector<std::string> arguments, int code = 0) {
        arguments.emplace_back("--json");
        const Answer run = run_quartic(arguments);
        EXPECT_EQ(run.code, code) << run.err;
        json document = json::parse(run.out, nullptr, false);
        EXPECT_FALSE(document.is_discarded()) << run.out;
        return document;
    }

    static std::string big_endian_at(const std::string& bytes, std::size_t at) {
        return bytes.substr(at, 4);
    }

    TemporaryFolder folder_;
};

TEST_F(Data, info_counts_the_tori_that_were_generated) {
    const json info = run_for_json({"info", generate("tori", {"--count", "7"})});
    EXPECT_EQ(info["schema"], 1);
    EXPECT_EQ(info["primitives"]["torus"], 7);
    EXPECT_EQ(info["primitives"]["cylinder"], 0);
    EXPECT_EQ(info["unit"], "m");
    EXPECT_EQ(info["findings"].is_array(), true);
    EXPECT_GT(info["peak_memory_bytes"], 0);
    EXPECT_LT(info["bounds"]["low"][0], info["bounds"]["high"][0]);
    EXPECT_GE(info["bytes_per_instance_gpu"], 48);
}

TEST_F(Data, same_seed_makes_the_same_bytes) {
    const std::string first = read_bytes(generate("plant", {"--seed", "5"}));
    const std::string second = read_bytes(generate("plant", {"--seed", "5"}));
    EXPECT_GT(first.size(), 1000u);
    EXPECT_EQ(first, second);
}

TEST_F(Data, converted_model_counts_the_same) {
    const std::string model = generate("plant");
    const std::string copy = folder_.path("copy.rvm");
    const Answer convert = run_quartic({"convert", model, "-o", copy});
    EXPECT_EQ(convert.code, 0) << convert.err;
    const json before = run_for_json({"info", model});
    const json after = run_for_json({"info", copy});
    EXPECT_GT(before["parts"], 10);
    EXPECT_EQ(before["primitives"], after["primitives"]);
}

TEST_F(Data, several_models_make_one_document) {
    const std::string model = generate("tori", {"--count", "2"});
    const json info = run_for_json({"info", model, model});
    ASSERT_EQ(info["files"].size(), 2u);
    EXPECT_EQ(info["files"][1]["primitives"]["torus"], 2);
}

TEST_F(Data, failed_work_prints_no_json) {
    const Answer run = run_quartic({"info", "/nowhere.rvm", "--json"});
    EXPECT_EQ(run.out, "");
}

TEST_F(Data, picture_has_the_size_that_was_asked_for) {
    const std::string output = folder_.path("a.png");
    const json render = run_for_json({"render", generate("tori", {"--count", "5"}), "-o", output,
                                      "--size", "48x32", "--samples", "2", "--frames", "3"});
    const std::string bytes = read_bytes(output);
    ASSERT_TRUE(bytes.starts_with("\x89PNG"));
    EXPECT_EQ(big_endian_at(bytes, 16), std::string("\0\0\0\x30", 4));
    EXPECT_EQ(big_endian_at(bytes, 20), std::string("\0\0\0\x20", 4));
    EXPECT_EQ(render["size"], json({48, 32}));
    EXPECT_EQ(render["frames"], 3);
    EXPECT_GT(render["frame_ms_median"], 0.0);
    EXPECT_EQ(render["nan_pixels"], 0);
    EXPECT_TRUE(render["culled"].contains("frustum"));
}

TEST_F(Data, picture_goes_to_standard_output) {
    const std::string model = generate("tori", {"--count", "2"});
    const Answer run = run_quartic({"render", model, "-o", "-", "--size", "16x16"});
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_TRUE(run.out.starts_with("\x89PNG"));
}

TEST_F(Data, depth_ids_and_normals_are_written) {
    const Answer run =
        run_quartic({"render", generate("tori", {"--count", "5"}), "-o", folder_.path("a.png"),
                     "--size", "32x32", "--depth", folder_.path("depth.exr"), "--ids",
                     folder_.path("ids.png"), "--normals", folder_.path("normals.png")});
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_TRUE(read_bytes(folder_.path("depth.exr")).starts_with("\x76\x2f\x31\x01"));
    EXPECT_TRUE(read_bytes(folder_.path("ids.png")).starts_with("\x89PNG"));
    EXPECT_TRUE(read_bytes(folder_.path("normals.png")).starts_with("\x89PNG"));
}

TEST_F(Data, reference_and_gpu_name_the_same_parts) {
    const std::string model = generate("tori", {"--count", "20"});
    for (const std::string device : {"gpu", "reference"}) {
        const Answer run =
            run_quartic({"render", model, "-o", folder_.path("a.png"), "--size", "64x48",
                         "--device", device, "--ids", folder_.path(device + ".png")});
        EXPECT_EQ(run.code, 0) << run.err;
    }
    EXPECT_EQ(read_bytes(folder_.path("gpu.png")), read_bytes(folder_.path("reference.png")));
}

TEST_F(Data, check_holds_for_tori) {
    const json check = run_for_json(
        {"check", generate("tori", {"--count", "20"}), "--views", "4", "--size", "80x60"});
    EXPECT_EQ(check["views"], 4);
    EXPECT_GT(check["hit_pixels"], 100);
    for (const char* what : {"missed", "false", "wrong_id"}) {
        EXPECT_EQ(check[what]["hard"], 0) << what;
    }
    EXPECT_LT(check["depth_error"]["max"], 1e-5);
    EXPECT_EQ(check["nan_pixels"], 0);
    EXPECT_EQ(check["gl_errors"], 0);
}

TEST_F(Data, bench_has_a_row_for_each_method) {
    const json bench =
        run_for_json({"bench", "load", generate("tori", {"--count", "20"}), "--rounds", "1"});
    EXPECT_EQ(bench["bench"], "load");
    ASSERT_EQ(bench["rows"].size(), 2u);
    EXPECT_EQ(bench["rows"][0]["method"], "parse");
    EXPECT_EQ(bench["rows"][1]["parts"], 20);
}

TEST_F(Data, lists_are_json_too) {
    EXPECT_EQ(run_for_json({"--list-solvers"})["solvers"][0]["name"], "convexity_split");
    EXPECT_FALSE(run_for_json({"--list-formats"})["formats"].empty());
    EXPECT_TRUE(run_for_json({"--system"}).contains("renderer"));
    EXPECT_TRUE(run_for_json({"--version"}).contains("version"));
}

}  // namespace
}  // namespace quartic
