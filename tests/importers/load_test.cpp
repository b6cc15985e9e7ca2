// Recognition by bytes, error texts, progress.
#include "tests/importers/rvm_bytes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace quartic {
namespace {

Error error_of(const std::string& name, std::string_view content) {
    const auto* first = reinterpret_cast<const std::byte*>(content.data());
    Progress progress;
    const Result<Scene> scene =
        load_scene(Source::from_bytes(name, std::vector<std::byte>(first, first + content.size())),
                   {}, progress);
    EXPECT_FALSE(scene.ok());
    return scene.ok() ? Error() : scene.error();
}

TEST(load, png_named_rvm_is_called_a_png) {
    const Error error = error_of("/models/pump.RVM", "\x89PNG\r\n\x1a\n and so on");
    EXPECT_EQ(error.kind, ErrorKind::bad_data);
    EXPECT_EQ(error.where, "/models/pump.RVM");
    EXPECT_EQ(error.message, "expected an AVEVA RVM model (.rvm); found a PNG image");
}

TEST(load, unknown_names_list_what_can_be_read) {
    const Error error = error_of("thing.xyz", "hello\nworld");
    EXPECT_NE(error.message.find("AVEVA RVM model (.rvm)"), std::string::npos);
    EXPECT_NE(error.message.find("text form"), std::string::npos);
    EXPECT_NE(error.message.find("text that begins with 'hello'"), std::string::npos);
}

TEST(load, empty_and_binary_files_are_described) {
    EXPECT_NE(error_of("a.rvm", "").message.find("an empty file"), std::string::npos);
    EXPECT_NE(error_of("a.rvm", std::string_view("\x01\x02\x00", 3)).message.find("bytes 01 02 00"),
              std::string::npos);
}

TEST(load, attribute_file_named_alone_points_to_the_model) {
    EXPECT_NE(error_of("a.att", "CADC_Attributes_File v1.0").message.find("open the .rvm"),
              std::string::npos);
}

TEST(load, bytes_decide_and_not_the_name) {
    const std::vector<std::byte> bytes =
        RvmBytes().head().group("G").primitive(8, {1, 2}).end_group().end();
    Progress progress;
    for (const char* name : {"a.rvm", "a.rev", "a.png", "a"}) {
        EXPECT_TRUE(load_scene(Source::from_bytes(name, bytes), {}, progress).ok()) << name;
    }
}

TEST(load, missing_file_and_folder_are_io_errors) {
    Progress progress;
    EXPECT_EQ(load_scene("/nowhere/at all.rvm", {}, progress).error().kind, ErrorKind::io);
    EXPECT_EQ(load_scene("/", {}, progress).error().kind, ErrorKind::io);
}

TEST(load, progress_grows_and_ends_at_one) {
    std::vector<double> seen;
    Progress progress([&](double fraction) { seen.push_back(fraction); });
    RvmBytes bytes;
    bytes.head().group("G");
    for (int i = 0; i < 30000; ++i) {
        bytes.primitive(8, {1, 2});
    }
    ImportOptions options;
    options.thread_count = 3;
    ASSERT_TRUE(
        load_scene(Source::from_bytes("a.rvm", bytes.end_group().end()), options, progress).ok());
    ASSERT_GT(seen.size(), 2u);
    EXPECT_TRUE(std::is_sorted(seen.begin(), seen.end()));
    EXPECT_EQ(seen.back(), 1.0);
}

TEST(load, table_rows_are_complete) {
    for (const Importer& importer : importer_table()) {
        EXPECT_FALSE(importer.name.empty());
        EXPECT_FALSE(importer.extensions.empty());
        EXPECT_NE(importer.recognises, nullptr);
        EXPECT_NE(importer.load, nullptr);
    }
}

}  // namespace
}  // namespace quartic
