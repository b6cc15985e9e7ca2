// Damaged RVM files: cut, flipped, looping. Each must give a result; sanitizers watch the rest.
#include "tests/importers/rvm_bytes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace quartic {
namespace {

// A file that has every chunk and every kind of record.
std::vector<std::byte> small_file() {
    RvmBytes bytes;
    bytes.head().group("/A").group_with_transparency("/B", 20, 4);
    bytes.primitive(8, {50, 100})
        .primitive(7, {50, 40, 100, 5, 6, 0.1f, 0, 0, 0.2f})
        .primitive(4, {100, 50, 1});
    bytes.chunk("INSU")
        .word(2)
        .word(0x1e000000)
        .numbers(plain_matrix)
        .numbers(wide_box)
        .numbers({1, 2, 3});
    bytes.chunk("OBST")
        .word(6)
        .numbers(plain_matrix)
        .numbers(wide_box)
        .word(0x1e000000)
        .numbers({100, 20});
    bytes.primitive(10, {5, 0}).primitive(9, {50});
    bytes.chunk("PRIM").word(11).numbers(plain_matrix).numbers(wide_box).word(1).word(2);
    bytes.word(4);
    for (const auto& [x, y] : {std::pair(0.0f, 0.0f), std::pair(9.0f, 0.0f), std::pair(9.0f, 9.0f),
                               std::pair(0.0f, 9.0f)}) {
        bytes.numbers({x, y, 0, 0, 0, 1});
    }
    bytes.word(3);
    for (const auto& [x, y] :
         {std::pair(2.0f, 2.0f), std::pair(2.0f, 5.0f), std::pair(5.0f, 2.0f)}) {
        bytes.numbers({x, y, 0, 0, 0, 1});
    }
    bytes.end_group().end_group().colour(1, 10, 20, 30);
    return bytes.end();
}

TEST(rvm_damage, whole_file_loses_nothing) {
    const Result<Scene> scene = load_bytes(small_file());
    ASSERT_TRUE(scene.ok());
    EXPECT_EQ(scene.value().parts.size(), 8u);
    EXPECT_EQ(scene.value().findings.count(Severity::loss), 0u);
    EXPECT_EQ(scene.value().findings.count(Severity::warning), 0u);
}

TEST(rvm_damage, file_cut_at_every_byte_is_an_error_or_says_what_it_lost) {
    const std::vector<std::byte> whole = small_file();
    std::size_t content = whole.size();
    while (whole[content - 1] == std::byte{0}) {
        --content;
    }
    std::size_t most_parts = 0;
    std::size_t errors = 0;
    for (std::size_t length = 0; length < content; ++length) {
        std::vector<std::byte> cut(whole.begin(),
                                   whole.begin() + static_cast<std::ptrdiff_t>(length));
        const Result<Scene> scene = load_bytes(std::move(cut));
        if (!scene) {
            ++errors;
            EXPECT_EQ(scene.error().kind, ErrorKind::bad_data);
            EXPECT_FALSE(scene.error().message.empty());
            continue;
        }
        const bool has_whole_end =
            length + 16 > content;  // only numbers that nobody reads are missing
        EXPECT_TRUE(has_whole_end || scene.value().findings.count(Severity::loss) > 0) << length;
        EXPECT_GE(scene.value().parts.size(), most_parts) << length;
        most_parts = scene.value().parts.size();
    }
    EXPECT_EQ(most_parts, 8u);
    EXPECT_GT(errors, 24u);
}

TEST(rvm_damage, every_flipped_bit_gives_a_result) {
    const std::vector<std::byte> whole = small_file();
    std::size_t loaded = 0;
    for (std::size_t bit = 0; bit < 8 * whole.size(); ++bit) {
        std::vector<std::byte> flipped = whole;
        flipped[bit / 8] ^= static_cast<std::byte>(1u << (bit % 8));
        const Result<Scene> scene = load_bytes(std::move(flipped));
        loaded += scene.ok() ? 1u : 0u;
        for (std::size_t i = 0; scene.ok() && i < scene.value().parts.size(); ++i) {
            const Part& part = scene.value().parts[i];
            ASSERT_LT(part.node, scene.value().nodes.size());
            ASSERT_LT(part.material, scene.value().materials.size());
            ASSERT_TRUE(std::isfinite(part.placement.position.x));
        }
    }
    EXPECT_GT(loaded, 7 * whole.size());  // most of a file is numbers
}

TEST(rvm_damage, next_offset_that_does_not_lead_forward_ends_the_reading) {
    RvmBytes probe;
    const auto at =
        static_cast<std::uint32_t>(probe.head().group("A").primitive(8, {50, 100}).header());
    for (const std::uint32_t next :
         {0u, 4u, at - 4, at, at + 4, at + 23, 0xffffffffu, 0x7fffffffu, 100000u}) {
        RvmBytes bytes;
        bytes.head().group("A").primitive(8, {50, 100}).next_offset(next);
        const Result<Scene> scene = load_bytes(bytes.end_group().end());
        ASSERT_TRUE(scene.ok());
        EXPECT_EQ(scene.value().nodes.size(), 1u);
        EXPECT_TRUE(scene.value().parts.empty());
        EXPECT_TRUE(has_finding(scene.value(), Severity::loss, "next offset")) << next;
    }
}

TEST(rvm_damage, next_offset_into_the_middle_ends_the_reading) {
    RvmBytes bytes;
    bytes.head().group("A").primitive(8, {50, 100});
    const auto header = static_cast<std::uint32_t>(bytes.header());
    bytes.next_offset(header + 40);
    const Result<Scene> scene = load_bytes(bytes.end_group().end());
    ASSERT_TRUE(scene.ok());
    EXPECT_TRUE(has_finding(scene.value(), Severity::loss, "expected a chunk"));
}

TEST(rvm_damage, string_longer_than_its_chunk_is_no_name) {
    RvmBytes bytes;
    bytes.head().chunk("CNTB", 2).word(0x3fffffff).word(7);
    const Result<Scene> scene = load_bytes(bytes.primitive(8, {50, 100}).end_group().end());
    ASSERT_TRUE(scene.ok());
    ASSERT_EQ(scene.value().nodes.size(), 1u);
    EXPECT_EQ(scene.value().strings[scene.value().nodes[0].name], "");
    EXPECT_EQ(scene.value().parts.size(), 1u);
    EXPECT_TRUE(has_finding(scene.value(), Severity::warning, "cut short"));
}

TEST(rvm_damage, header_alone_is_an_error) {
    RvmBytes bytes;
    const std::vector<std::byte> whole = bytes.head().end();
    const std::vector<std::byte> cut(whole.begin(), whole.begin() + 148);
    const Result<Scene> scene = load_bytes(cut);
    ASSERT_FALSE(scene.ok());
    EXPECT_EQ(scene.error().kind, ErrorKind::bad_data);
    EXPECT_TRUE(load_bytes(whole).ok());  // a model without groups, but a whole one
}

TEST(rvm_damage, cancelled_import_is_interrupted) {
    Progress progress;
    progress.cancel();
    const Result<Scene> scene = load_scene(Source::from_bytes("test", small_file()), {}, progress);
    ASSERT_FALSE(scene.ok());
    EXPECT_EQ(scene.error().kind, ErrorKind::interrupted);
}

}  // namespace
}  // namespace quartic
