// Files that are missing, empty, foreign, damaged, or cannot be written.
#include "tests/cli/run_program.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace quartic {
namespace {

void expect_one_line(const Answer& run, int code, const std::string& part) {
    EXPECT_EQ(run.code, code) << run.err;
    EXPECT_EQ(run.out, "");
    EXPECT_EQ(count_lines(run.err), 1u) << run.err;
    EXPECT_TRUE(run.err.starts_with("quartic: ")) << run.err;
    EXPECT_NE(run.err.find(part), std::string::npos) << run.err;
}

TEST(Files, empty_model_is_bad) {
    const TemporaryFolder folder;
    const std::string model = folder.write("empty.rvm", "");
    expect_one_line(run_quartic({"info", model, "--json"}), 1, "empty.rvm");
    expect_one_line(run_quartic({"render", model, "-o", folder.path("a.png")}), 1, "empty.rvm");
    EXPECT_EQ(folder.file_count(), 1u);
}

TEST(Files, foreign_bytes_are_bad) {
    const TemporaryFolder folder;
    const std::string model = folder.write("a.rvm", "This is no model, whatever its name says.");
    expect_one_line(run_quartic({"info", model}), 1, "a.rvm");
}

TEST(Files, truncated_model_is_done_in_part_unless_strict) {
    const TemporaryFolder folder;
    const std::string whole = folder.path("whole.rvm");
    ASSERT_EQ(run_quartic({"generate", "tori", "--count", "50", "-o", whole, "--quiet"}).code, 0);
    const std::string bytes = read_bytes(whole);
    const std::string part = folder.write("part.rvm", bytes.substr(0, bytes.size() / 2));
    const Answer answer = run_quartic({"info", part, "--json", "--quiet"});
    EXPECT_EQ(answer.code, 3);
    EXPECT_NE(answer.err.find("done in part"), std::string::npos) << answer.err;
    EXPECT_TRUE(answer.out.starts_with("{")) << answer.out;
    EXPECT_EQ(run_quartic({"info", part, "--strict"}).code, 1);
}

TEST(Files, missing_model_cannot_be_read) {
    expect_one_line(run_quartic({"info", "/nowhere/a.rvm"}), 4, "/nowhere/a.rvm");
}

TEST(Files, folder_is_no_model) {
    expect_one_line(run_quartic({"info", "/"}), 4, "directory");
}

TEST(Files, name_with_line_breaks_still_makes_one_line) {
    expect_one_line(run_quartic({"info", "/nowhere/a\nb.rvm"}), 4, "/nowhere/a b.rvm");
}

TEST(Files, output_in_a_missing_folder_cannot_be_written) {
    const TemporaryFolder folder;
    const std::string output = folder.path("missing/a.rvm");
    expect_one_line(run_quartic({"generate", "tori", "--count", "3", "-o", output}), 4, output);
}

TEST(Files, folder_is_no_output) {
    const TemporaryFolder folder;
    const std::string output = folder.path("a.rvm");
    std::filesystem::create_directory(output);
    expect_one_line(run_quartic({"generate", "tori", "--count", "3", "-o", output}), 4,
                    "regular file");
}

TEST(Files, unknown_output_format_is_named) {
    expect_one_line(run_quartic({"convert", "a.rvm", "-o", "a.xyz"}), 2, "a.xyz");
}

TEST(Files, old_output_stays_when_the_work_fails) {
    const TemporaryFolder folder;
    const std::string model = folder.write("bad.rvm", "not a model");
    const std::string output = folder.write("old.png", "old");
    EXPECT_EQ(run_quartic({"render", model, "-o", output}).code, 1);
    EXPECT_EQ(read_bytes(output), "old");
    EXPECT_EQ(folder.file_count(), 2u);
}

TEST(Files, several_files_become_one_model) {
    const TemporaryFolder folder;
    const std::string tori = folder.path("tori.rvm");
    const std::string run = folder.path("run.rvm");
    const std::string both = folder.path("both.rvm");
    ASSERT_EQ(run_quartic({"generate", "tori", "--count", "3", "-o", tori, "--quiet"}).code, 0);
    ASSERT_EQ(run_quartic({"generate", "run", "-o", run, "--quiet"}).code, 0);
    ASSERT_EQ(run_quartic({"convert", tori, run, "-o", both, "--quiet"}).code, 0);
    const auto parts = [](const std::string& path) {
        const Answer info = run_quartic({"info", path, "--json"});
        return nlohmann::json::parse(info.out).at("parts").get<int>();
    };
    EXPECT_EQ(parts(both), parts(tori) + parts(run));
    expect_one_line(run_quartic({"render", tori, "missing.rvm", "-o", folder.path("a.png")}), 4,
                    "missing.rvm");
}

TEST(Files, solvers_of_materials_are_checked_before_the_model_is_read) {
    for (const char* rule : {"newton", "(=newton", ".*=nobody"}) {
        const Answer run =
            run_quartic({"render", "missing.rvm", "-o", "a.png", "--material-solver", rule});
        EXPECT_EQ(run.code, 2) << rule << ": " << run.err;
    }
}

TEST(Files, material_solver_changes_what_is_drawn) {
    const TemporaryFolder folder;
    const std::string tori = folder.path("tori.rvm");
    ASSERT_EQ(run_quartic({"generate", "tori", "--count", "30", "-o", tori, "--quiet"}).code, 0);
    const auto missed = [&](const std::string& rule) {
        const Answer run = run_quartic(
            {"check", tori, "--views", "6", "--size", "200", "--json", "--material-solver", rule});
        return nlohmann::json::parse(run.out).at("missed").at("hard").get<int>();
    };
    EXPECT_GT(missed(".*=newton"), 0);
    EXPECT_EQ(missed(".*=convexity_split"), 0);
    EXPECT_EQ(missed("no such material=newton"), 0);
}

TEST(Files, no_usable_opengl_has_its_own_exit_code) {
    const TemporaryFolder folder;
    const std::string model = folder.path("tori.rvm");
    ASSERT_EQ(run_quartic({"generate", "tori", "--count", "3", "-o", model, "--quiet"}).code, 0);
    const Environment none{{"__EGL_VENDOR_LIBRARY_FILENAMES", "/nonexistent.json"}};
    const Answer run = run_quartic({"render", model, "-o", folder.path("a.png")}, none);
    expect_one_line(run, 5, "OpenGL");
    EXPECT_EQ(folder.file_count(), 1u);
}

TEST(Files, reference_needs_no_opengl) {
    const TemporaryFolder folder;
    const std::string model = folder.path("tori.rvm");
    ASSERT_EQ(run_quartic({"generate", "tori", "--count", "3", "-o", model, "--quiet"}).code, 0);
    const Environment none{{"__EGL_VENDOR_LIBRARY_FILENAMES", "/nonexistent.json"}};
    const std::string output = folder.path("a.png");
    const Answer run = run_quartic(
        {"render", model, "-o", output, "--size", "40x30", "--device", "reference", "--quiet"},
        none);
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_EQ(run.err, "");
    EXPECT_TRUE(read_bytes(output).starts_with("\x89PNG"));
}

}  // namespace
}  // namespace quartic
