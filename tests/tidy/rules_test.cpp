// Plants an offender for each rule and sees it caught, and its law-abiding neighbour pass.
#include "tests/tidy/rules.h"
#include "tests/tidy/code.h"

#include <gtest/gtest.h>

#include <string>

namespace quartic::tidy {
namespace {

std::string repeat(const std::string& text, int count) {
    std::string all;
    for (int i = 0; i < count; ++i) {
        all += text;
    }
    return all;
}

// The paths of the offences, in order.
std::string paths(const Offences& offences) {
    std::string all;
    for (const Offence& offence : offences) {
        all += (all.empty() ? "" : " ") + offence.path;
    }
    return all;
}

TEST(Includes, importer_that_includes_render_is_caught) {
    const Tree tree{{"render/renderer.h", ""},
                    {"scene/scene.h", ""},
                    {"importers/good.cpp", "#include \"scene/scene.h\"\n"},
                    {"importers/rvm.cpp", "// Reads.\n#include \"render/renderer.h\"\n"}};
    const Offences offences = find_forbidden_includes(tree);
    ASSERT_EQ(paths(offences), "importers/rvm.cpp");
    EXPECT_EQ(offences[0].line, 2u);
}

TEST(Includes, nobody_includes_tests_or_the_cli) {
    const Tree tree{{"tests/a.h", ""},
                    {"cli/a.h", ""},
                    {"viewer/a.cpp", "#include \"cli/a.h\"\n"},
                    {"cli/a.cpp", "#include \"tests/a.h\"\n"},
                    {"tests/b.cpp", "#include \"cli/a.h\"\n"}};
    EXPECT_EQ(paths(find_forbidden_includes(tree)), "cli/a.cpp viewer/a.cpp");
}

TEST(Includes, path_that_does_not_start_at_the_root_is_caught) {
    const Tree tree{{"scene/scene.h", ""}, {"scene/scene.cpp", "#include \"scene.h\"\n"}};
    EXPECT_EQ(paths(find_forbidden_includes(tree)), "scene/scene.cpp");
}

TEST(Includes, unknown_folder_is_caught) {
    const Tree tree{{"scene/scene.h", ""}, {"attic/a.cpp", "#include \"scene/scene.h\"\n"}};
    EXPECT_EQ(paths(find_forbidden_includes(tree)), "attic/a.cpp");
}

TEST(Includes, library_away_from_its_home_is_caught) {
    const Tree tree{{"scene/a.cpp", "#include <epoxy/gl.h>\n"},
                    {"render/a.cpp", "#include <epoxy/gl.h>\n"},
                    {"tests/gpu/a.cpp", "#include <epoxy/gl.h>\n"}};
    EXPECT_EQ(paths(find_foreign_includes(tree)), "scene/a.cpp");
}

TEST(Includes, thirteen_own_includes_are_caught) {
    std::string text;
    for (char c = 'a'; c < 'a' + 13; ++c) {
        text += "#include \"scene/" + std::string(1, c) + ".h\"\n";
    }
    const std::string twelve = text.substr(text.find('\n') + 1);
    const Tree tree{{"scene/many.cpp", text}, {"scene/twelve.cpp", twelve + "#include <map>\n"}};
    EXPECT_EQ(paths(find_many_includes(tree)), "scene/many.cpp");
}

TEST(GlCalls, outside_render_and_viewer_are_caught) {
    const Tree tree{
        {"cli/a.cpp", "void f() { glFinish(); }\n"},
        {"cli/b.cpp", "int x = GL_TRUE;\n"},
        {"cli/c.cpp", "// glFinish() waits\nglm::vec3 v; const char* s = \"glFinish()\";\n"},
        {"render/a.cpp", "void f() { glFinish(); }\n"}};
    EXPECT_EQ(paths(find_gl_calls(tree)), "cli/a.cpp cli/b.cpp");
}

TEST(Sizes, line_of_101_columns_is_caught) {
    const Tree tree{{"scene/a.cpp", repeat("x", 101)},
                    {"scene/b.cpp", repeat("x", 100)},
                    {"scene/c.cpp", repeat("\xc3\xa4", 100)},
                    {"docs/a.md", repeat("|x", 100)},
                    {"docs/b.md", repeat("x", 133)}};
    EXPECT_EQ(paths(find_long_lines(tree)), "docs/b.md scene/a.cpp");
}

TEST(Sizes, function_of_71_lines_is_caught) {
    const std::string head = "// Opens.\nstruct A {\nint f(int x)\n{\n";
    const Tree tree{{"scene/a.cpp", head + repeat("x = x * 2;\n", 68) + "}\n};\n"},
                    {"scene/b.cpp", head + repeat("x = x * 2;\n", 67) + "}\n};\n"},
                    {"scene/c.cpp", "struct A {\n" + repeat("int x;\n", 90) + "};\n"}};
    const Offences offences = find_long_functions(tree);
    ASSERT_EQ(paths(offences), "scene/a.cpp");
    EXPECT_EQ(offences[0].line, 3u);
}

TEST(Sizes, braces_in_comments_literals_and_macros_do_not_confuse_functions) {
    const std::string text =
        "#define OPEN(x) \\\n    f(x) {\nvoid f() {\n    // }}}\n"
        "    char c = '}'; /* } */ auto s = \"}\\\"}\";\n    auto r = R\"(}\")\";\n}\n";
    const std::vector<Function> functions = functions_of(text);
    ASSERT_EQ(functions.size(), 1u);
    EXPECT_EQ(functions[0].line, 3u);
    EXPECT_EQ(functions[0].line_count, 5u);
}

TEST(Sizes, long_lambda_is_caught) {
    const std::string text =
        "const auto f = make(1, [&](int x) {\n" + repeat("x = x;\n", 75) + "});\n";
    EXPECT_EQ(paths(find_long_functions({{"scene/a.cpp", text}})), "scene/a.cpp");
}

TEST(Sizes, long_files_are_caught_by_their_kind) {
    const Tree tree{{"CMakeLists.txt", repeat("\n", 101)}, {"primitives/a.glsl", repeat("\n", 181)},
                    {"scene/a.cpp", repeat("\n", 501)},    {"scene/a.h", repeat("\n", 251)},
                    {"scene/b.cpp", repeat("\n", 500)},    {"shaders/a.frag", repeat("\n", 151)},
                    {"solvers/a.glsl", repeat("\n", 201)}, {"solvers/b.glsl", repeat("\n", 200)}};
    EXPECT_EQ(
        paths(find_long_files(tree)),
        "CMakeLists.txt primitives/a.glsl scene/a.cpp scene/a.h shaders/a.frag solvers/a.glsl");
}

TEST(Names, banned_stems_are_caught) {
    const Tree tree{{"scene/mesh_utils.h", ""}, {"scene/helper.cpp", ""}, {"scene/database.h", ""}};
    EXPECT_EQ(paths(find_banned_names(tree)), "scene/helper.cpp scene/mesh_utils.h");
}

TEST(Unused, source_that_no_list_names_is_caught) {
    const Tree tree{
        {"scene/CMakeLists.txt", "quartic_library(scene SOURCES used.cpp sub/used.cpp)"},
        {"scene/used.cpp", ""},
        {"scene/sub/used.cpp", ""},
        {"scene/left.cpp", ""},
        {"render/used.cpp", ""}};
    EXPECT_EQ(paths(find_unused_files(tree)), "render/used.cpp scene/left.cpp");
}

TEST(Unused, header_shader_module_and_page_that_nobody_names_are_caught) {
    const Tree tree{{"CMakeLists.txt", "include(targets)"},
                    {"cmake/targets.cmake", ""},
                    {"cmake/left.cmake", ""},
                    {"docs/README.md", "see used.md"},
                    {"docs/left.md", ""},
                    {"docs/used.md", ""},
                    {"scene/left.h", "#include \"scene/left.h\"\n"},
                    {"scene/used.h", ""},
                    {"scene/CMakeLists.txt", "SOURCES a.cpp"},
                    {"scene/a.cpp", "#include \"scene/used.h\"\nload(\"shaders/used.frag\");\n"},
                    {"shaders/left.frag", ""},
                    {"shaders/used.frag", ""}};
    EXPECT_EQ(paths(find_unused_files(tree)),
              "cmake/left.cmake docs/left.md scene/left.h shaders/left.frag");
}

TEST(Markers, left_behind_are_caught) {
    const std::string marker = std::string("TO") + "DO";
    const Tree tree{{"scene/a.cpp", "\n// " + marker + ": later\n"}, {"scene/b.cpp", "// Todos\n"}};
    const Offences offences = find_left_markers(tree);
    ASSERT_EQ(paths(offences), "scene/a.cpp");
    EXPECT_EQ(offences[0].line, 2u);
}

TEST(FirstSentence, missing_one_is_caught) {
    const Tree tree{{"docs/a.md", "no title\n"},
                    {"dev", "#!/bin/bash\n# Says what it is.\n"},
                    {"scene/a.h", "#pragma once\n"},
                    {"scene/b.h", "// words without an end\n#pragma once\n"},
                    {"scene/c.h", "// A sentence over\n// two lines.\n#pragma once\n"},
                    {"scene/d.h", "\n// Late.\n"}};
    EXPECT_EQ(paths(find_missing_first_sentences(tree)), "docs/a.md scene/a.h scene/b.h scene/d.h");
}

TEST(Readme, folder_without_one_is_caught) {
    const Tree tree{{".ci/run", ""},
                    {"scene/a.h", ""},
                    {"tests/README.md", "# Tests\n`gpu/` needs OpenGL\n"},
                    {"tests/gpu/a.cpp", ""},
                    {"tests/odd/a.cpp", ""}};
    EXPECT_EQ(paths(find_folders_without_readme(tree)), "scene tests/odd");
}

TEST(Links, dead_one_is_caught) {
    const Tree tree{{"README.md", "# A\n[b](docs/b.md#part) [c](docs) [d](https://example.org)\n"},
                    {"docs/b.md", "# B\n[up](../README.md) ![gone](images/gone.png)\n"}};
    const Offences offences = find_dead_links(tree);
    ASSERT_EQ(paths(offences), "docs/b.md");
    EXPECT_EQ(offences[0].line, 2u);
}

}  // namespace
}  // namespace quartic::tidy
