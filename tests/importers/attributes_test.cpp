// Attribute files: grammar, join by the path of names, the file beside the model, damage.
#include "importers/attributes.h"
#include "tests/importers/rvm_bytes.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace quartic {
namespace {

const std::string first_line =
    "CADC_Attributes_File v1.0 , start: NEW , end: END , name_end: := , sep: &end&\n";

Scene tree() {
    Result<Scene> scene = load_bytes(RvmBytes()
                                         .head()
                                         .group("/S")
                                         .group("P")
                                         .end_group()
                                         .group("P")
                                         .end_group()
                                         .group("Q")
                                         .group("P")
                                         .end_group()
                                         .end_group()
                                         .end_group()
                                         .end());
    return std::move(scene).value();
}

Source text_source(const std::string& text) {
    const auto* first = reinterpret_cast<const std::byte*>(text.data());
    return Source::from_bytes("test.att", std::vector<std::byte>(first, first + text.size()));
}

Status join(Scene& scene, const std::string& text) {
    Progress progress;
    return join_attributes(scene, text_source(text), progress);
}

std::string attributes_of(const Scene& scene, std::uint32_t node) {
    std::string all;
    for (std::uint32_t i = 0; i < scene.nodes[node].attribute_count; ++i) {
        const Attribute& attribute = scene.attributes[scene.nodes[node].first_attribute + i];
        all += std::string(scene.strings[attribute.key]) + '=' +
               std::string(scene.strings[attribute.value]) + ';';
    }
    return all;
}

TEST(attributes, join_by_path_and_equal_names_in_order) {
    Scene scene = tree();
    ASSERT_TRUE(
        join(scene, first_line +
                        "NEW Header Information\n  Source:= PDMS Data &end& Date:= today\nEND\n"
                        "NEW /S\n  Type:= 'SITE'\n  NEW P\n    Tag:= 'one'\n  END\n  NEW P\n    "
                        "Tag:= 'two'\n"
                        "  END\n  NEW Q\n    NEW P\n      Tag:= 'three' &end& Bore:= 50 &end& "
                        "Note:= 'a b'\n"
                        "    END\n  END\n  NEW STRANGER\n    NEW P\n      Tag:= 'no'\n    END\n  "
                        "END\nEND\n")
            .ok());
    EXPECT_EQ(attributes_of(scene, 0), "Type=SITE;");
    EXPECT_EQ(attributes_of(scene, 1), "Tag=one;");
    EXPECT_EQ(attributes_of(scene, 2), "Tag=two;");
    EXPECT_EQ(attributes_of(scene, 4), "Tag=three;Bore=50;Note=a b;");
    EXPECT_TRUE(has_finding(scene, Severity::note, "5 of 7 elements"));
    EXPECT_EQ(scene.findings.count(Severity::warning), 0u);
}

TEST(attributes, words_of_the_first_line_are_honoured) {
    Scene scene = tree();
    ASSERT_TRUE(
        join(scene,
             "\xef\xbb\xbf"
             "CADC_Attributes_File v1.0 , start: BEGIN , end: STOP , name_end: == , sep: |\r\n"
             "BEGIN /S\r\n  Type== 'SITE' | Tag== 'NEW END := x'\r\nSTOP\r\n")
            .ok());
    EXPECT_EQ(attributes_of(scene, 0), "Type=SITE;Tag=NEW END := x;");
}

TEST(attributes, other_files_are_refused) {
    Scene scene = tree();
    EXPECT_FALSE(join(scene, "NEW /S\n  Type:= 'SITE'\nEND\n").ok());
    EXPECT_FALSE(join(scene, "").ok());
}

TEST(attributes, unbalanced_and_nameless_lines_are_warnings) {
    Scene scene = tree();
    ASSERT_TRUE(join(scene, first_line + "END\nNEW /S\n  nonsense\n  Type:= 'SITE'\n").ok());
    EXPECT_EQ(attributes_of(scene, 0), "Type=SITE;");
    EXPECT_EQ(scene.findings.count(Severity::warning), 3u);
}

TEST(attributes, file_cut_at_every_byte_never_invents_anything) {
    const std::string whole =
        first_line + "NEW /S\n  Type:= 'SITE' &end& Tag:= 'T-1'\n  NEW P\n    A:= 1\n  END\nEND\n";
    for (std::size_t length = 0; length <= whole.size(); ++length) {
        Scene scene = tree();
        const Status status = join(scene, whole.substr(0, length));
        EXPECT_EQ(status.ok(), length >= 20) << length;
        EXPECT_LE(scene.attributes.size(), 3u);
        for (const Node& node : scene.nodes) {
            ASSERT_LE(node.first_attribute + node.attribute_count, scene.attributes.size());
        }
    }
}

TEST(attributes, a_million_nested_elements_join) {
    std::string text = first_line;
    for (int i = 0; i < 1000000; ++i) {
        text += "NEW /S\n";
    }
    Scene scene = tree();
    EXPECT_TRUE(join(scene, text).ok());
}

class AttributesBesideModel : public testing::Test {
protected:
    void SetUp() override {
        folder_ = std::filesystem::temp_directory_path() /
                  ("quartic_attributes_" +
                   std::to_string(::testing::UnitTest::GetInstance()->random_seed()) + "_" +
                   ::testing::UnitTest::GetInstance()->current_test_info()->name());
        std::filesystem::remove_all(folder_);
        std::filesystem::create_directories(folder_);
        const std::vector<std::byte> model =
            RvmBytes().head().group("/S").primitive(8, {1, 2}).end_group().end();
        write("Model.RVM", {reinterpret_cast<const char*>(model.data()), model.size()});
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    void write(const std::string& name, const std::string& content) {
        std::ofstream(folder_ / name, std::ios::binary) << content;
    }
    Result<Scene> load(const ImportOptions& options = {}) {
        Progress progress;
        return load_scene((folder_ / "Model.RVM").string(), options, progress);
    }
    static std::string tagged(const std::string& tag) {
        return first_line + "NEW /S\n  Tag:= '" + tag + "'\nEND\n";
    }

    std::filesystem::path folder_;
};

TEST_F(AttributesBesideModel, are_found_in_any_letter_case) {
    write("model.Att", tagged("found"));
    const Result<Scene> scene = load();
    ASSERT_TRUE(scene.ok());
    EXPECT_EQ(attributes_of(scene.value(), 0), "Tag=found;");
}

TEST_F(AttributesBesideModel, att_goes_before_txt_and_the_named_file_before_both) {
    write("Model.txt", tagged("txt"));
    EXPECT_EQ(attributes_of(load().value(), 0), "Tag=txt;");
    write("Model.att", tagged("att"));
    EXPECT_EQ(attributes_of(load().value(), 0), "Tag=att;");
    write("other.dat", tagged("named"));
    ImportOptions options;
    options.attributes_path = (folder_ / "other.dat").string();
    EXPECT_EQ(attributes_of(load(options).value(), 0), "Tag=named;");
}

TEST_F(AttributesBesideModel, other_text_is_ignored_unless_it_was_named) {
    write("Model.txt", "shopping list\n");
    EXPECT_TRUE(load().ok());
    ImportOptions options;
    options.attributes_path = (folder_ / "Model.txt").string();
    EXPECT_FALSE(load(options).ok());
    options.attributes_path = (folder_ / "missing.att").string();
    const Result<Scene> missing = load(options);
    ASSERT_FALSE(missing.ok());
    EXPECT_EQ(missing.error().kind, ErrorKind::io);
}

}  // namespace
}  // namespace quartic
