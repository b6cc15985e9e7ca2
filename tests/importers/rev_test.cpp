// The text form from hand-made text: every kind, layers, damage.
#include "tests/importers/rvm_bytes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace quartic {
namespace {

const std::string head =
    "HEAD\r\n     1     1\r\nprogram\r\nnote\r\ndate\r\nuser\r\nMODL\r\n     1     "
    "1\r\nP\r\n/M\r\n";
const std::string group =
    "CNTB\r\n     1     1\r\n/A\r\n    1000.00000    2000.00000    3000.00000\r\n     2\r\n";
const std::string matrix =
    "       0.00100       0.00000       0.00000       1.00000\r\n"
    "       0.00000       0.00100       0.00000       2.00000\r\n"
    "       0.00000       0.00000       0.00100       3.00000\r\n";
const std::string box =
    "     -50.00000     -50.00000    -100.00000\r\n      50.00000      50.00000     100.00000\r\n";
const std::string tail = "CNTE\r\n     1     1\r\nEND:\r\n     1     1\r\n";

std::string primitive(int kind, const std::string& parameters, const std::string& id = "PRIM") {
    return id + "\r\n     1     1\r\n     " + std::to_string(kind) + "\r\n" + matrix + box +
           parameters + "\r\n";
}

Scene load_sound(const std::string& text) {
    Result<Scene> scene = load_text(text);
    EXPECT_TRUE(scene.ok()) << (scene.ok() ? "" : scene.error().message);
    return scene.ok() ? std::move(scene).value() : Scene();
}

TEST(rev, cylinder_with_either_line_ending) {
    std::string text = head + group + primitive(8, "      50.00000     200.00000") + tail;
    for (int round = 0; round < 2; ++round) {
        const Scene scene = load_sound(text);
        ASSERT_EQ(scene.shapes.cylinder.size(), 1u);
        EXPECT_DOUBLE_EQ(scene.shapes.cylinder[0].radius, 0.05);
        EXPECT_DOUBLE_EQ(scene.shapes.cylinder[0].height, 0.2);
        EXPECT_EQ(scene.parts[0].placement.position, glm::dvec3(1, 2, 3));
        EXPECT_EQ(scene.strings[scene.nodes[0].name], "/A");
        EXPECT_EQ(scene.title, "/M");
        EXPECT_EQ(scene.materials[0].colour, glm::vec4(1, 0, 0, 1));
        EXPECT_EQ(scene.findings.count(Severity::warning), 0u);
        std::erase(text, '\r');
    }
}

TEST(rev, every_kind_is_read) {
    const Scene scene =
        load_sound(head + group + primitive(1, "1 2 3 4\n5 6 7") + primitive(2, "1 2 3") +
                   primitive(3, "10 20 5 1") + primitive(4, "10 5 1") + primitive(5, "10 5") +
                   primitive(6, "10 5") + primitive(7, "10 20 5 1 2\n0.1 0 0 0") +
                   primitive(8, "1 2") + primitive(9, "50") + primitive(10, "5 0") +
                   primitive(11, "1\n1\n3\n0 0 0\n0 0 1\n10 0 0\n0 0 1\n0 10 0\n0 0 1") + tail);
    EXPECT_EQ(scene.parts.size(), 11u);
    EXPECT_EQ(count_of(scene, "dish"), 2u);
    for (const char* kind : {"pyramid", "box", "rectangular_torus", "torus", "snout", "cylinder",
                             "sphere", "line", "facet_group"}) {
        EXPECT_EQ(count_of(scene, kind), 1u) << kind;
    }
    EXPECT_DOUBLE_EQ(scene.shapes.sphere[0].radius, 0.05);
    EXPECT_EQ(scene.findings.count(Severity::loss), 0u);
}

TEST(rev, rounded_axes_are_made_square_and_the_scale_is_exact) {
    // A turn of 0.3 radians about z with five decimals: 0.000955 and 0.000296 become 0.00096 and
    // 0.00030.
    const std::string turned =
        "       0.00096      -0.00030       0.00000       1.00000\n"
        "       0.00030       0.00096       0.00000       2.00000\n"
        "       0.00000       0.00000       0.00100       3.00000\n";
    const Scene scene =
        load_sound(head + group + "PRIM\n 1 1\n 8\n" + turned + box + "50 200\n" + tail);
    ASSERT_EQ(scene.shapes.cylinder.size(), 1u);
    EXPECT_DOUBLE_EQ(scene.shapes.cylinder[0].radius, 0.05);
    const glm::dquat rotation = scene.parts[0].placement.rotation;
    EXPECT_NEAR(glm::length(rotation), 1.0, 1e-15);
    const glm::dvec3 x = rotation * glm::dvec3(1, 0, 0);
    EXPECT_NEAR(std::atan2(x.y, x.x), 0.3, 0.005);
    EXPECT_NEAR(x.z, 0.0, 1e-15);
}

TEST(rev, volumes_have_their_transparency_in_either_place) {
    const std::string first = "INSU\n 1 1\n 8\n    40\n" + matrix + box + "50 200\n";
    const std::string last = "OBST\n 1 1\n 8\n" + matrix + box + "    40\n50 200\n";
    const Scene scene = load_sound(head + group + first + last + tail);
    ASSERT_EQ(scene.parts.size(), 2u);
    EXPECT_EQ(scene.parts[0].layer, Layer::insulation);
    EXPECT_EQ(scene.parts[1].layer, Layer::obstruction);
    for (const Part& part : scene.parts) {
        EXPECT_FLOAT_EQ(scene.materials[part.material].colour.a, 0.6f);
        EXPECT_DOUBLE_EQ(scene.shapes.cylinder[part.shape].height, 0.2);
    }
}

TEST(rev, colour_after_the_tree_holds) {
    const Scene scene = load_sound(head + group + primitive(8, "50 200") +
                                   "CNTE\n 1 1\nCOLR\n 1 1\n 2\n 0 255 0\nEND:\n 1 1\n");
    ASSERT_EQ(scene.materials.size(), 1u);
    EXPECT_EQ(scene.materials[0].colour, glm::vec4(0, 1, 0, 1));
}

TEST(rev, numbers_that_are_none_lose_their_part_only) {
    const Scene scene = load_sound(head + group + primitive(8, "1.#QNAN 200") +
                                   primitive(8, "nan 200") + primitive(8, "1e999 200") +
                                   primitive(8, "what 200") + primitive(8, "50 200") + tail);
    EXPECT_EQ(scene.parts.size(), 1u);
    EXPECT_EQ(count_of(scene, "cylinder"), 5u);
    EXPECT_EQ(scene.findings.count(Severity::loss), 4u);
}

TEST(rev, one_line_of_a_million_numbers_is_no_trouble) {
    std::string line = "50 200";
    for (int i = 0; i < 1000000; ++i) {
        line += " 1";
    }
    EXPECT_EQ(load_sound(head + group + primitive(8, line) + tail).parts.size(), 1u);
}

TEST(rev, huge_facet_counts_are_a_loss) {
    for (const char* facets : {"4294967295\n1\n3\n0 0 0\n0 0 1", "1\n4294967295\n3",
                               "1\n1\n4294967295\n0 0 0", "1e300\n1\n3", "-1\n1\n3", "1.5\n1\n3"}) {
        const Scene scene = load_sound(head + group + primitive(11, facets) + tail);
        EXPECT_EQ(count_of(scene, "facet_group"), 1u);
        EXPECT_EQ(scene.findings.count(Severity::loss), 1u) << facets;
    }
}

TEST(rev, text_cut_at_every_byte_is_an_error_or_says_what_it_lost) {
    const std::string whole =
        head + group + primitive(8, "      50.00000     200.00000") + group +
        primitive(7, "10 20 5 1 2\r\n0.1 0 0 0") +
        primitive(11, "1\r\n1\r\n3\r\n0 0 0\r\n0 0 1\r\n10 0 0\r\n0 0 1\r\n0 10 0\r\n0 0 1") +
        "CNTE\r\n     1     1\r\n" + tail;
    const std::size_t end = whole.find("END:") + 4;
    std::size_t most_parts = 0;
    for (std::size_t length = 0; length < end; ++length) {
        const Result<Scene> scene = load_text(std::string_view(whole).substr(0, length));
        if (!scene) {
            EXPECT_EQ(scene.error().kind, ErrorKind::bad_data);
            continue;
        }
        EXPECT_GT(scene.value().findings.count(Severity::loss), 0u) << length;
        EXPECT_GE(scene.value().parts.size(), most_parts) << length;
        most_parts = scene.value().parts.size();
        for (const f64::Cylinder& cylinder : scene.value().shapes.cylinder) {
            EXPECT_DOUBLE_EQ(cylinder.height, 0.2) << length;  // never a number cut in half
        }
    }
    EXPECT_EQ(most_parts, 3u);
    EXPECT_EQ(load_sound(whole).findings.count(Severity::loss), 0u);
}

TEST(rev, every_flipped_bit_gives_a_result) {
    const std::string whole = head + group + primitive(8, "      50.00000     200.00000") + tail;
    std::size_t loaded = 0;
    for (std::size_t bit = 0; bit < 8 * whole.size(); ++bit) {
        std::string flipped = whole;
        flipped[bit / 8] = static_cast<char>(flipped[bit / 8] ^ (1 << (bit % 8)));
        loaded += load_text(flipped).ok() ? 1u : 0u;
    }
    EXPECT_GT(loaded, 6 * whole.size());
}

}  // namespace
}  // namespace quartic
