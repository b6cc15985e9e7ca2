// Places legends and names in pictures.
#include "cli/legend.h"

#include "cli/lettering.h"

#include <algorithm>

namespace quartic::cli {
namespace {

constexpr Rgb ink{20, 20, 20};
constexpr Rgb paper{255, 255, 255};
constexpr int bar_width = 150;  // these are multiplied by the scale
constexpr int bar_height = 8;
constexpr int swatch = 7;
constexpr int margin = 5;

// Letters of about a fiftieth of the picture's height.
int scale_of(PixelSize size) {
    return std::clamp(std::min(size.width / 400, size.height / 300), 1, 8);
}

PixelSize size_of(const Lettering& lettering, const Legend& legend) {
    const int scale = lettering.scale();
    int width = lettering.width_of(legend.title);
    int height = lettering.line_height() * (1 + static_cast<int>(legend.lines.size()));
    if (!legend.ticks.empty()) {
        // The outer ticks' texts stand half beside the bar.
        width = std::max(width, bar_width * scale + lettering.width_of(legend.ticks.back().text));
        height += lettering.line_height() + (bar_height + 4) * scale;
    }
    for (const LegendLine& line : legend.lines) {
        width = std::max(width, 2 * swatch * scale + lettering.width_of(line.text));
    }
    return {width + 2 * margin * scale, height + 2 * margin * scale};
}

// The bar from x on, and its ticks' texts below it; returns where the next line stands.
int draw_bar(Lettering& lettering, int x, int y, const Legend& legend) {
    const int scale = lettering.scale();
    const int left = x + lettering.width_of(legend.ticks.front().text) / 2;
    const int width = bar_width * scale;
    for (int i = 0; i < width; ++i) {
        lettering.fill({left + i, y, 1, bar_height * scale},
                       heat_colour(static_cast<double>(i) / (width - 1)));
    }
    const int below = y + (bar_height + 3) * scale;
    for (const LegendTick& tick : legend.ticks) {
        const int at = left + static_cast<int>(tick.place * (width - scale));
        lettering.fill({at, y + bar_height * scale, scale, 2 * scale}, ink);
        lettering.write(at - lettering.width_of(tick.text) / 2, below, tick.text, ink);
    }
    return below + lettering.line_height();
}

}  // namespace

int divider_of(PixelSize size) {
    return size.width / 2;
}

void draw_legend(std::vector<std::uint8_t>& rgba, PixelSize size, const Legend& legend) {
    Lettering lettering(rgba, size, scale_of(size));
    const int scale = lettering.scale();
    const PixelSize panel = size_of(lettering, legend);
    const int x = margin * scale;
    int y = size.height - margin * scale - panel.height;
    if (y < 0 || x + panel.width > size.width) {
        return;
    }
    lettering.fill({x, y, panel.width, panel.height}, paper, 0.85);
    const int inside = x + margin * scale;
    y += margin * scale;
    lettering.write(inside, y, legend.title, ink);
    y += lettering.line_height();
    if (!legend.ticks.empty()) {
        y = draw_bar(lettering, inside, y, legend);
    }
    for (const LegendLine& line : legend.lines) {
        lettering.fill({inside, y, swatch * scale, swatch * scale}, line.colour);
        lettering.write(inside + 2 * swatch * scale, y, line.text, ink);
        y += lettering.line_height();
    }
}

void draw_divider(std::vector<std::uint8_t>& rgba, PixelSize size, const std::string& left,
                  const std::string& right) {
    Lettering lettering(rgba, size, scale_of(size));
    const int scale = lettering.scale();
    const int middle = divider_of(size);
    lettering.fill({middle - scale, 0, scale, size.height}, paper);
    lettering.fill({middle, 0, scale, size.height}, ink);
    lettering.write_label(margin * scale, margin * scale, left);
    lettering.write_label(middle + margin * scale, margin * scale, right);
}

}  // namespace quartic::cli
