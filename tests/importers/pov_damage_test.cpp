// POV-Ray scenes that are cut, nested without end, or grow without end when they are expanded.
#include "tests/importers/text_models.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace quartic {
namespace {

Result<Scene> load_pov(const std::string& text) {
    return load_text(text, "/nowhere/test.pov");
}

const std::string small_file = R"(#version 3.7; #include "shapes.inc" // a comment
#declare A = 2*<1,2,3>.x; #declare Tone = color rgb <0.1,0.2,0.3>*2;
#declare S = cubic { <1,0,0,1, 0,0,0,0,0,0, 0,0,4,0,0,0, 0,9,0,-1> clipped_by { box { -2, 2 } } }
union { object { S scale <1,2,-3> } sphere { 0, A } /* here */ pigment { Tone } rotate 30*x }
intersection { torus { 2, 0.5 rotate 90*x } plane { <0,-1,0>, 0 } plane { <1,0,0>, 0 } }
mesh2 { vertex_vectors { 3, <0,0,0>, <1,0,0>, <0,1,0> } face_indices { 1, <0,1,2> } }
cylinder { -y, y, 1 open texture { pigment { checker Red, White } finish { phong 1 } } }
#ifdef (A) disc { 0, z, 1 } #else box { -1, 1 } #end camera { location <0,0,-9> })";

void expect_finite(const Scene& scene) {
    for (const Part& part : scene.parts) {
        const Box3 box = world_bounds(scene, part);
        ASSERT_TRUE(std::isfinite(glm::length(box.low)) && std::isfinite(glm::length(box.high)));
    }
}

TEST(PovDamage, the_whole_file_loses_nothing) {
    const Result<Scene> scene = load_pov(small_file);
    ASSERT_TRUE(scene.ok());
    EXPECT_EQ(scene.value().parts.size(), 11u);  // six cubes of the cubic in its box
    EXPECT_EQ(scene.value().findings.count(Severity::loss), 0u);
}

TEST(PovDamage, a_file_cut_at_every_byte_gives_a_scene_or_an_error) {
    std::size_t most = 0;
    for (std::size_t size = 0; size < small_file.size(); ++size) {
        const Result<Scene> scene = load_pov(small_file.substr(0, size));
        if (scene) {
            expect_finite(scene.value());
            most = std::max(most, scene.value().parts.size());
        } else {
            EXPECT_FALSE(scene.error().message.empty());
        }
    }
    EXPECT_EQ(most, 11u);
}

TEST(PovDamage, a_file_with_any_byte_replaced_gives_a_scene_or_an_error) {
    std::size_t loaded = 0;
    for (std::size_t at = 0; at < small_file.size(); ++at) {
        for (const char c : {'{', '}', '<', '#', '9', '\0', '"'}) {
            std::string text = small_file;
            text[at] = c;
            const Result<Scene> scene = load_pov(text);
            if (scene) {
                expect_finite(scene.value());
                ++loaded;
            }
        }
    }
    EXPECT_GT(loaded, small_file.size());
}

TEST(PovDamage, nesting_without_end_is_a_loss) {
    for (const std::string& opening :
         {std::string("union { "), std::string("object { S "), std::string("sphere { (("),
          std::string("clipped_by { "), std::string("sphere { 0, 1 clipped_by { ")}) {
        std::string text = "sphere { 0, 1 } #declare S = sphere { 0, 1 } ";
        for (int i = 0; i < 100'000; ++i) {
            text += opening;
        }
        const Result<Scene> scene = load_pov(text);
        ASSERT_TRUE(scene.ok()) << opening;
        EXPECT_GT(scene.value().findings.count(Severity::loss) +
                      scene.value().findings.count(Severity::warning),
                  0u);
    }
    std::string brackets = "sphere { 0, 1 } sphere { " + std::string(1'000'000, '(');
    EXPECT_TRUE(load_pov(brackets).ok());
}

TEST(PovDamage, a_chain_of_declarations_is_cut_where_it_gets_too_deep) {
    std::string text = "#declare A0 = sphere { 0, 1 }\n";
    for (int i = 1; i < 20'000; ++i) {
        text += "#declare A" + std::to_string(i) + " = object { A" + std::to_string(i - 1) + " }\n";
    }
    const Result<Scene> scene = load_pov(text + "object { A10 } object { A19999 }");
    ASSERT_TRUE(scene.ok());
    EXPECT_EQ(scene.value().parts.size(), 1u);
    EXPECT_GT(scene.value().findings.count(Severity::loss), 0u);
}

TEST(PovDamage, objects_that_double_in_each_line_stop_at_a_limit) {
    for (const std::string& seed : {std::string("sphere { 0, 1 }"), std::string("union { }")}) {
        std::string text = "#declare A0 = " + seed + "\nsphere { 0, 1 }\n";
        for (int i = 1; i < 40; ++i) {
            const std::string inner = "object { A" + std::to_string(i - 1) + " } ";
            text += "#declare A" + std::to_string(i) + " = union { " + inner + inner + "}\n";
        }
        const Result<Scene> scene = load_pov(text + "object { A39 } object { A20 }");
        ASSERT_TRUE(scene.ok());
        EXPECT_LE(scene.value().parts.size(), 300'000u);
        EXPECT_GT(scene.value().findings.count(Severity::loss), 0u);
    }
}

TEST(PovDamage, numbers_beyond_all_bounds_are_refused) {
    const std::string zeros = "0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,-1";
    for (const std::string& text :
         {std::string("sphere { 0, 1e999 }"), std::string("sphere { <1/0, 0, 0>, 1 }"),
          std::string("sphere { 0, 1 scale 1e200 scale 1e200 }"), "cubic { <1e999," + zeros + "> }",
          "cubic { <1," + zeros + "> clipped_by { box { -1, 1 } } scale <1e-120,1e-120,1e-120> }",
          "cubic { <1," + zeros + "> clipped_by { box { 1, 1 } } }", std::string("box { 0, 0 }"),
          std::string("cylinder { 0, 0, 1 }"), std::string("disc { 0, 0, 1 }"),
          std::string("torus { 1, 2 }")}) {
        const Result<Scene> scene = load_pov("sphere { 0, 1 }\n" + text);
        ASSERT_TRUE(scene.ok()) << text;
        EXPECT_EQ(scene.value().parts.size(), 1u) << text;
        EXPECT_GT(scene.value().findings.count(Severity::loss), 0u) << text;
    }
}

}  // namespace
}  // namespace quartic
