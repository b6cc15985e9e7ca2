// Writes plots as SVG: a frame, ticks, lines with markers or bars, and a legend.
#include "bench/plot.h"

#include "bench/plot_scale.h"

#include <algorithm>
#include <array>
#include <cstdio>

namespace quartic {
namespace {

constexpr double width = 960.0;
constexpr double line_plot_height = 560.0;
constexpr double top = 64.0;
constexpr double bottom_margin = 64.0;
constexpr double right_margin = 36.0;
constexpr double legend_line = 20.0;
constexpr double bar_height = 16.0;
constexpr double bar_gap = 10.0;  // between categories

// Colours that people with any colour vision tell apart (Okabe, Ito 2008), yellow left out: it is
// too pale for lines on white.
constexpr std::array colours = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                "#000000", "#e69f00", "#56b4e9", "#7f7f7f"};

std::string number(double value) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.1f", value);
    return text.data();
}

std::string escaped(const std::string& text) {
    std::string result;
    for (const char c : text) {
        switch (c) {
            case '&': result += "&amp;"; break;
            case '<': result += "&lt;"; break;
            case '>': result += "&gt;"; break;
            case '"': result += "&quot;"; break;
            default: result += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
        }
    }
    return result;
}

// The area between the axes, in the units of the picture; y grows downwards.
struct Area {
    double left;
    double right;
    double top;
    double bottom;
    double x(double part) const { return left + part * (right - left); }
    double y(double part) const { return bottom - part * (bottom - top); }
};

std::string text_at(double x, double y, const std::string& text, const std::string& more) {
    return "<text x=\"" + number(x) + "\" y=\"" + number(y) + "\" " + more + ">" + escaped(text) +
           "</text>\n";
}

std::string line_from(double x0, double y0, double x1, double y1, const std::string& more) {
    return "<line x1=\"" + number(x0) + "\" y1=\"" + number(y0) + "\" x2=\"" + number(x1) +
           "\" y2=\"" + number(y1) + "\" " + more + "/>\n";
}

const char* colour_of(std::size_t series) {
    return colours[series % colours.size()];
}

// Shapes change with every series, so that colours alone do not carry the meaning.
std::string marker(double x, double y, std::size_t series) {
    const std::string fill = "fill=\"" + std::string(colour_of(series)) + "\"";
    switch (series % 3) {
        case 0:
            return "<circle cx=\"" + number(x) + "\" cy=\"" + number(y) + "\" r=\"4\" " + fill +
                   "/>\n";
        case 1:
            return "<rect x=\"" + number(x - 3.5) + "\" y=\"" + number(y - 3.5) +
                   "\" width=\"7\" height=\"7\" " + fill + "/>\n";
        default:
            return "<polygon points=\"" + number(x) + "," + number(y - 5.0) + " " +
                   number(x + 4.5) + "," + number(y + 4.0) + " " + number(x - 4.5) + "," +
                   number(y + 4.0) + "\" " + fill + "/>\n";
    }
}

std::vector<double> values_of(const Plot& plot, double PlotPoint::*member) {
    std::vector<double> values;
    for (const Series& series : plot.series) {
        for (const PlotPoint& point : series.points) {
            values.push_back(point.*member);
        }
    }
    return values;
}

std::string grid_across(const Area& area, const PlotScale& scale) {
    std::string svg;
    for (const double tick : scale.ticks()) {
        const double x = area.x(scale.part(tick));
        svg += line_from(x, area.top, x, area.bottom, "stroke=\"#dddddd\"");
        svg += text_at(x, area.bottom + 18.0, tick_text(tick), "text-anchor=\"middle\"");
    }
    return svg;
}

std::string grid_up(const Area& area, const PlotScale& scale) {
    std::string svg;
    for (const double tick : scale.ticks()) {
        const double y = area.y(scale.part(tick));
        svg += line_from(area.left, y, area.right, y, "stroke=\"#dddddd\"");
        svg += text_at(area.left - 8.0, y + 4.0, tick_text(tick), "text-anchor=\"end\"");
    }
    return svg;
}

std::string frame(const Area& area) {
    return "<rect x=\"" + number(area.left) + "\" y=\"" + number(area.top) + "\" width=\"" +
           number(area.right - area.left) + "\" height=\"" + number(area.bottom - area.top) +
           "\" fill=\"none\" stroke=\"#444444\"/>\n";
}

std::string lines(const Plot& plot, const Area& area) {
    const PlotScale across(values_of(plot, &PlotPoint::x), plot.x.logarithmic);
    const PlotScale up(values_of(plot, &PlotPoint::y), plot.y.logarithmic);
    std::string svg = grid_across(area, across) + grid_up(area, up) + frame(area);
    for (std::size_t i = 0; i < plot.series.size(); ++i) {
        std::string path;
        std::string markers;
        for (const PlotPoint& point : plot.series[i].points) {
            if (across.shows(point.x) && up.shows(point.y)) {
                const double x = area.x(across.part(point.x));
                const double y = area.y(up.part(point.y));
                path += (path.empty() ? "" : " ") + number(x) + "," + number(y);
                markers += marker(x, y, i);
            }
        }
        // Gaps, so that a line below shows where two lie on each other.
        const std::string gaps = i < 4 ? "" : " stroke-dasharray=\"8 6\"";
        svg += "<polyline points=\"" + path + "\" fill=\"none\" stroke-width=\"2\" stroke=\"" +
               colour_of(i) + "\"" + gaps + "/>\n" + markers;
    }
    const double middle = 0.5 * (area.top + area.bottom);
    svg += text_at(18.0, middle, plot.y.label,
                   "text-anchor=\"middle\" transform=\"rotate(-90 18 " + number(middle) + ")\"");
    return svg;
}

std::string bars(const Plot& plot, const Area& area) {
    const PlotScale scale(values_of(plot, &PlotPoint::x), plot.x.logarithmic);
    const double pitch = bar_gap + bar_height * static_cast<double>(plot.series.size());
    std::string svg = grid_across(area, scale) + frame(area);
    for (std::size_t i = 0; i < plot.categories.size(); ++i) {
        const double y = area.top + bar_gap + pitch * static_cast<double>(i);
        svg += text_at(area.left - 8.0, y + 0.5 * (pitch - bar_gap) + 4.0, plot.categories[i],
                       "text-anchor=\"end\"");
    }
    for (std::size_t i = 0; i < plot.series.size(); ++i) {
        for (const PlotPoint& point : plot.series[i].points) {
            if (!scale.shows(point.x)) {
                continue;
            }
            const double y =
                area.top + bar_gap + pitch * point.y + bar_height * static_cast<double>(i);
            const double length = std::max(1.0, area.x(scale.part(point.x)) - area.left);
            svg += "<rect x=\"" + number(area.left) + "\" y=\"" + number(y) + "\" width=\"" +
                   number(length) + "\" height=\"" + number(bar_height - 2.0) + "\" fill=\"" +
                   colour_of(i) + "\"/>\n";
            // Beside the bar, or in it where it fills the plot.
            const bool beside = length < 0.9 * (area.right - area.left);
            svg += text_at(area.left + length + (beside ? 4.0 : -4.0), y + bar_height - 5.0,
                           tick_text(point.x),
                           beside ? "font-size=\"11\""
                                  : "font-size=\"11\" text-anchor=\"end\" fill=\"white\"");
        }
    }
    return svg;
}

std::string legend(const Plot& plot, double y) {
    std::string svg;
    constexpr std::size_t columns = 4;
    for (std::size_t i = 0; i < plot.series.size(); ++i) {
        const double x = 24.0 + (width - 48.0) / columns * static_cast<double>(i % columns);
        const double line = y + legend_line * static_cast<double>(i / columns);
        svg += marker(x, line - 4.0, i) + text_at(x + 10.0, line, plot.series[i].name, "");
    }
    return svg;
}

std::string bar_legend(const Plot& plot, double y) {
    std::string svg;
    double x = 24.0;
    for (std::size_t i = 0; i < plot.series.size(); ++i) {
        svg += "<rect x=\"" + number(x) + "\" y=\"" + number(y - 10.0) +
               "\" width=\"12\" height=\"12\" fill=\"" + colour_of(i) + "\"/>\n" +
               text_at(x + 18.0, y, plot.series[i].name, "");
        x += 48.0 + 7.5 * static_cast<double>(plot.series[i].name.size());
    }
    return svg;
}

double plot_height(const Plot& plot) {
    if (plot.categories.empty()) {
        return line_plot_height;
    }
    const double pitch = bar_gap + bar_height * static_cast<double>(plot.series.size());
    return top + bar_gap + pitch * static_cast<double>(plot.categories.size()) + bottom_margin;
}

double label_width(const Plot& plot) {
    std::size_t longest = 0;
    for (const std::string& category : plot.categories) {
        longest = std::max(longest, category.size());
    }
    return std::min(0.4 * width, 7.5 * static_cast<double>(longest));
}

}  // namespace

std::string as_svg(const Plot& plot) {
    const bool has_bars = !plot.categories.empty();
    const double plot_bottom = plot_height(plot);
    const double legend_rows = has_bars ? 1.0 : static_cast<double>((plot.series.size() + 3) / 4);
    const double height = plot_bottom + legend_line * (legend_rows + 0.5);
    const Area area{has_bars ? 24.0 + label_width(plot) : 84.0, width - right_margin, top,
                    plot_bottom - bottom_margin};
    std::string svg =
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg "
        "xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" width=\"" +
        number(width) + "\" height=\"" + number(height) + "\" viewBox=\"0 0 " + number(width) +
        " " + number(height) +
        "\" font-family=\"DejaVu Sans, sans-serif\" font-size=\"12\">\n<title>" +
        escaped(plot.title) + "</title>\n<desc>" + escaped(plot.caption) +
        "</desc>\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n";
    svg += text_at(24.0, 28.0, plot.title, "font-size=\"18\"");
    svg += text_at(24.0, 48.0, plot.caption, "fill=\"#555555\"");
    svg += has_bars ? bars(plot, area) : lines(plot, area);
    svg += text_at(0.5 * (area.left + area.right), area.bottom + 40.0, plot.x.label,
                   "text-anchor=\"middle\"");
    svg += has_bars ? bar_legend(plot, plot_bottom) : legend(plot, plot_bottom);
    return svg + "</svg>\n";
}

}  // namespace quartic
