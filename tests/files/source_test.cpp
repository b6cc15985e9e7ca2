// A source is a regular file's bytes, or bytes from memory; anything else is an error at once.
#include "files/source.h"
#include "tests/files/temporary_folder.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cstring>
#include <utility>

namespace quartic {
namespace {

std::string text_of(const Source& source) {
    const auto bytes = source.bytes();
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

TEST(Source, holds_the_bytes_of_a_file) {
    const TemporaryFolder folder;
    const Result<Source> source = Source::open(folder.write("a", std::string("a\0b", 3)));
    ASSERT_TRUE(source.ok());
    EXPECT_EQ(text_of(source.value()), std::string("a\0b", 3));
    EXPECT_EQ(source.value().path(), folder.path("a"));
}

TEST(Source, empty_file_is_no_error) {
    const TemporaryFolder folder;
    const Result<Source> source = Source::open(folder.write("a", ""));
    ASSERT_TRUE(source.ok());
    EXPECT_TRUE(source.value().bytes().empty());
}

TEST(Source, moved_source_keeps_its_bytes) {
    std::vector<std::byte> bytes(3);
    std::memcpy(bytes.data(), "abc", 3);
    Source first = Source::from_bytes("memory", bytes);
    Source second = Source::from_bytes("other", {});
    second = std::move(first);
    EXPECT_EQ(text_of(second), "abc");
    EXPECT_EQ(second.path(), "memory");
}

TEST(Source, missing_file_is_an_error_that_names_it) {
    const Result<Source> source = Source::open("/nowhere/a.rvm");
    ASSERT_FALSE(source.ok());
    EXPECT_EQ(source.error().kind, ErrorKind::io);
    EXPECT_EQ(source.error().where, "/nowhere/a.rvm");
}

TEST(Source, folder_is_an_error) {
    const TemporaryFolder folder;
    const Result<Source> source = Source::open(folder.path("."));
    ASSERT_FALSE(source.ok());
    EXPECT_NE(source.error().message.find("directory"), std::string::npos);
}

// Nobody writes to it: opening it must not wait.
TEST(Source, fifo_is_an_error_at_once) {
    const TemporaryFolder folder;
    ASSERT_EQ(::mkfifo(folder.path("fifo").c_str(), 0600), 0);
    const Result<Source> source = Source::open(folder.path("fifo"));
    ASSERT_FALSE(source.ok());
    EXPECT_NE(source.error().message.find("standard input"), std::string::npos);
}

}  // namespace
}  // namespace quartic
