// Reports as JSON, CSV, Markdown and text.
#include "bench/report.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace quartic {
namespace {

using nlohmann::ordered_json;

Report report() {
    Report report;
    report.bench = "one-thing";
    report.conditions = {"a renderer", true, {64, 48}, 3};
    Table rows;
    rows.key = "rows";
    rows.columns = {{"method", "method", {}}, {"fps", "", {"0deg", "90deg"}}, {"ratio", "x", {}}};
    rows.rows.push_back({{"method", "a, \"b\""}, {"fps", {1.5, 2.0}}, {"ratio", nullptr}});
    rows.rows.push_back({{"method", "c|d"}, {"fps", {3.0, 4.0}}, {"ratio", 0.123456789}});
    Table view{"", "Another look", {{"fps", "fps", {"0deg", "90deg"}}}, rows.rows};
    Table extra{"extra", "More", {{"count", "n", {}}}, ordered_json::array()};
    extra.rows.push_back({{"count", 7}});
    report.tables = {rows, view, extra};
    report.notes = {"A note."};
    return report;
}

TEST(Report, csv_quotes_commas_and_quotes_and_spreads_lists) {
    EXPECT_EQ(as_csv(report()),
              "method,fps_0deg,fps_90deg,ratio,renderer,size_px,rounds,clock\n"
              "\"a, \"\"b\"\"\",1.5,2,,a renderer,64x48,3,wall\n"
              "c|d,3,4,0.123456789,a renderer,64x48,3,wall\n");
}

TEST(Report, csv_has_as_many_cells_in_each_line_where_rows_lack_keys) {
    Report bare = report();
    bare.tables[0].rows.push_back({{"method", "nothing else"}});
    const std::string csv = as_csv(bare);
    EXPECT_NE(csv.find("nothing else,,,,a renderer"), std::string::npos) << csv;
}

TEST(Report, json_holds_conditions_rows_and_further_tables) {
    const ordered_json json = as_json(report());
    EXPECT_EQ(json["bench"], "one-thing");
    EXPECT_EQ(json["renderer"], "a renderer");
    EXPECT_EQ(json["software"], true);
    EXPECT_EQ(json["clock"], "wall");
    EXPECT_EQ(json["rounds"], 3);
    EXPECT_EQ(json["size"], ordered_json({64, 48}));
    EXPECT_EQ(json["rows"].size(), 2u);
    EXPECT_EQ(json["rows"][0]["fps"][1], 2.0);
    EXPECT_EQ(json["extra"][0]["count"], 7);
    EXPECT_FALSE(json.contains(""));
}

TEST(Report, json_of_what_draws_nothing_has_no_renderer) {
    Report undrawn = report();
    undrawn.conditions = {};
    EXPECT_TRUE(as_json(undrawn)["renderer"].is_null());
    EXPECT_FALSE(as_json(undrawn).contains("size"));
}

TEST(Report, markdown_says_the_conditions_and_escapes_bars) {
    const std::string text = as_markdown(report());
    EXPECT_TRUE(
        text.starts_with("# one-thing\n\na renderer (software), 64x48, wall clock, median "
                         "of 3 rounds\n"))
        << text;
    EXPECT_NE(text.find("| method | x |\n|---|--:|\n| a, \"b\" |  |\n| c\\|d | 0.1235 |\n"),
              std::string::npos)
        << text;
    EXPECT_NE(text.find("## Another look\n\n| fps 0deg | fps 90deg |"), std::string::npos) << text;
    EXPECT_NE(text.find("A note."), std::string::npos);
}

TEST(Report, text_aligns_its_columns) {
    const std::string text = as_text(report());
    EXPECT_NE(text.find("method       x\n"), std::string::npos) << text;
    EXPECT_NE(text.find("c|d     0.1235\n"), std::string::npos) << text;
}

}  // namespace
}  // namespace quartic
