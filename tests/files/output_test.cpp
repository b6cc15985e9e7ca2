// An output is there whole or not at all, and nothing is left beside it.
#include "files/output.h"
#include "tests/files/temporary_folder.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <utility>

namespace quartic {
namespace {

TEST(Output, is_not_there_before_it_is_committed) {
    const TemporaryFolder folder;
    Result<Output> output = Output::create(folder.path("a"));
    ASSERT_TRUE(output.ok());
    output.value().write("text");
    EXPECT_FALSE(std::filesystem::exists(folder.path("a")));
    EXPECT_TRUE(output.value().commit().ok());
    EXPECT_EQ(folder.read("a"), "text");
    EXPECT_EQ(folder.file_count(), 1u);
}

TEST(Output, without_commit_leaves_the_old_file_and_nothing_beside_it) {
    const TemporaryFolder folder;
    folder.write("a", "old");
    {
        Result<Output> output = Output::create(folder.path("a"));
        ASSERT_TRUE(output.ok());
        output.value().write("new");
    }
    EXPECT_EQ(folder.read("a"), "old");
    EXPECT_EQ(folder.file_count(), 1u);
}

TEST(Output, replaces_the_old_file_and_keeps_its_mode) {
    const TemporaryFolder folder;
    ::chmod(folder.write("a", "old and longer").c_str(), 0640);
    ASSERT_TRUE(write_file(folder.path("a"), std::as_bytes(std::span("new", 3))).ok());
    EXPECT_EQ(folder.read("a"), "new");
    struct stat status {};
    ASSERT_EQ(::stat(folder.path("a").c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 0777u, 0640u);
}

TEST(Output, moved_from_output_removes_nothing) {
    const TemporaryFolder folder;
    Result<Output> created = Output::create(folder.path("a"));
    ASSERT_TRUE(created.ok());
    Output output = std::move(created).value();
    output.write("text");
    EXPECT_TRUE(output.commit().ok());
    EXPECT_EQ(folder.read("a"), "text");
}

TEST(Output, bigger_than_any_buffer_is_whole) {
    const TemporaryFolder folder;
    const std::string bytes(5'000'003, 'x');
    ASSERT_TRUE(write_file(folder.path("a"), std::as_bytes(std::span(bytes))).ok());
    EXPECT_EQ(folder.read("a"), bytes);
}

TEST(Output, folder_cannot_be_replaced) {
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder.path("a"));
    const Result<Output> output = Output::create(folder.path("a"));
    ASSERT_FALSE(output.ok());
    EXPECT_EQ(output.error().kind, ErrorKind::io);
    EXPECT_EQ(output.error().where, folder.path("a"));
}

TEST(Output, in_a_missing_folder_is_an_error) {
    const Result<Output> output = Output::create("/nowhere/at/all");
    ASSERT_FALSE(output.ok());
    EXPECT_EQ(output.error().kind, ErrorKind::io);
}

}  // namespace
}  // namespace quartic
