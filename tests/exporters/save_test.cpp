// Exporters are found by the name's extension.
#include "exporters/save.h"

#include <gtest/gtest.h>

namespace quartic {
namespace {

TEST(Save, the_extension_chooses_the_exporter_in_any_case) {
    ASSERT_NE(find_exporter("plant.rvm"), nullptr);
    EXPECT_EQ(find_exporter("/a/b.c/PLANT.RVM"), find_exporter("plant.rvm"));
}

TEST(Save, other_names_have_no_exporter) {
    EXPECT_EQ(find_exporter("plant"), nullptr);
    EXPECT_EQ(find_exporter("plant.unknown"), nullptr);
    EXPECT_EQ(find_exporter("folder.rvm/plant"), nullptr);
    EXPECT_EQ(find_exporter(""), nullptr);
}

TEST(Save, an_unknown_extension_is_a_usage_error_that_names_the_known_ones) {
    const Status status = save_scene(Scene(), "/nowhere/plant.unknown");
    ASSERT_FALSE(status.ok());
    EXPECT_EQ(status.error().kind, ErrorKind::usage);
    EXPECT_NE(status.error().message.find(".rvm"), std::string::npos);
}

TEST(Save, a_folder_that_is_not_there_is_an_io_error) {
    const Status status = save_scene(Scene(), "/nowhere/at/all/plant.rvm");
    ASSERT_FALSE(status.ok());
    EXPECT_EQ(status.error().kind, ErrorKind::io);
}

TEST(Save, every_row_of_the_table_is_complete) {
    for (const Exporter& exporter : exporter_table()) {
        EXPECT_FALSE(exporter.name.empty());
        EXPECT_FALSE(exporter.extensions.empty());
        EXPECT_NE(exporter.save, nullptr);
    }
}

}  // namespace
}  // namespace quartic
