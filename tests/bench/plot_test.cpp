// Plots: well-formed XML, ticks, and places along the axes.
#include "bench/plot.h"
#include "bench/plot_scale.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace quartic {
namespace {

// The first fault of a text as XML: tags that do not match, or a sign that must be escaped.
std::string xml_fault(const std::string& text) {
    std::vector<std::string> open;
    std::size_t at = text.find("?>") + 2;
    while (at < text.size()) {
        if (text[at] != '<') {
            const bool entity = text[at] != '&' || text.find(';', at) < at + 7;
            if (text[at] == '>' || !entity) {
                return "a bare sign at " + std::to_string(at);
            }
            ++at;
            continue;
        }
        const std::size_t end = text.find('>', at);
        const std::string tag = text.substr(at + 1, end - at - 1);
        if (end == std::string::npos || std::count(tag.begin(), tag.end(), '"') % 2 != 0 ||
            tag.find('<') != std::string::npos) {
            return "a broken tag: " + tag;
        }
        const std::string name = tag.substr(0, tag.find_first_of(" /"));
        if (tag.starts_with('/')) {
            if (open.empty() || open.back() != tag.substr(1)) {
                return "a stray end of " + tag.substr(1);
            }
            open.pop_back();
        } else if (!tag.ends_with('/')) {
            open.push_back(name);
        }
        at = end + 1;
    }
    return open.empty() ? std::string() : open.back() + " is not closed";
}

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t found = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
        ++found;
    }
    return found;
}

Plot lines() {
    Plot plot;
    plot.title = "Speed & <size>";
    plot.caption = "\"quoted\"";
    plot.x = {"count", true};
    plot.y = {"ms", true};
    plot.series = {{"a<b", {{1.0, 2.0}, {10.0, 20.0}, {100.0, 0.0}}}, {"c", {{1.0, 5.0}}}};
    return plot;
}

TEST(Plot, lines_are_well_formed_xml) {
    const std::string svg = as_svg(lines());
    EXPECT_EQ(xml_fault(svg), "");
    EXPECT_NE(svg.find("Speed &amp; &lt;size&gt;"), std::string::npos);
}

TEST(Plot, values_without_a_logarithm_are_left_out) {
    // Two points and the legend's marker of the first series: the third point is at zero.
    EXPECT_EQ(count(as_svg(lines()), "<circle"), 3u);
}

TEST(Plot, bars_are_well_formed_and_there_is_one_for_each_value) {
    Plot plot;
    plot.title = "bars";
    plot.categories = {"one & only", "two", "three"};
    plot.series = {{"frame", {{1.0, 0.0}, {2.0, 1.0}, {0.5, 2.0}}}, {"paper", {{1.5, 1.0}}}};
    const std::string svg = as_svg(plot);
    EXPECT_EQ(xml_fault(svg), "");
    // The background, the frame, two in the legend, and four bars.
    EXPECT_EQ(count(svg, "<rect"), 8u);
}

TEST(Plot, nothing_to_show_is_still_a_picture) {
    EXPECT_EQ(xml_fault(as_svg(Plot())), "");
    Plot nothing = lines();
    nothing.series = {{"nan", {{std::nan(""), -1.0}}}};
    const std::string svg = as_svg(nothing);
    EXPECT_EQ(xml_fault(svg), "");
    EXPECT_EQ(svg.find("nan,"), std::string::npos);
}

TEST(PlotScale, linear_ticks_are_round_and_start_at_zero) {
    const PlotScale scale({3.0, 7.4}, false);
    EXPECT_EQ(scale.ticks(), (std::vector<double>{0.0, 2.0, 4.0, 6.0, 8.0}));
    EXPECT_DOUBLE_EQ(scale.part(0.0), 0.0);
    EXPECT_DOUBLE_EQ(scale.part(4.0), 0.5);
}

TEST(PlotScale, logarithmic_ticks_are_powers_of_ten) {
    const PlotScale scale({2.0, 16384.0}, true);
    EXPECT_DOUBLE_EQ(scale.part(1.0), 0.0);
    EXPECT_NEAR(scale.part(1000.0), 0.6, 1e-12);
    const std::vector<double> ticks = scale.ticks();
    ASSERT_EQ(ticks.size(), 6u);
    EXPECT_NEAR(ticks[5], 1e5, 1e-6);
    EXPECT_FALSE(scale.shows(0.0));
    EXPECT_FALSE(scale.shows(-1.0));
}

TEST(PlotScale, ticks_are_short) {
    EXPECT_EQ(tick_text(0.0), "0");
    EXPECT_EQ(tick_text(0.25), "0.25");
    EXPECT_EQ(tick_text(1000.0), "1000");
    EXPECT_EQ(tick_text(20000.0), "20k");
    EXPECT_EQ(tick_text(1e6), "1M");
    EXPECT_EQ(tick_text(1e-7), "1e-07");
}

}  // namespace
}  // namespace quartic
