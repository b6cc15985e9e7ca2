// Draws glyphs as boxes.
#include "cli/lettering.h"

#include "cli/font.h"

#include <algorithm>
#include <cmath>

namespace quartic::cli {
namespace {

constexpr int advance_px = glyph_width_px + 1;
constexpr Rgb ink{20, 20, 20};
constexpr Rgb paper{255, 255, 255};

std::uint8_t blended(std::uint8_t below, std::uint8_t above, double opacity) {
    return static_cast<std::uint8_t>(std::lround(below + opacity * (above - below)));
}

}  // namespace

void Lettering::fill(const Area& area, const Rgb& colour, double opacity) {
    const int right = std::min(area.x + area.width, size_.width);
    const int bottom = std::min(area.y + area.height, size_.height);
    for (int y = std::max(area.y, 0); y < bottom; ++y) {
        for (int x = std::max(area.x, 0); x < right; ++x) {
            std::uint8_t* pixel = &rgba_[4 * pixel_index(size_, x, size_.height - 1 - y)];
            pixel[0] = blended(pixel[0], colour.red, opacity);
            pixel[1] = blended(pixel[1], colour.green, opacity);
            pixel[2] = blended(pixel[2], colour.blue, opacity);
            pixel[3] = 255;
        }
    }
}

void Lettering::write(int x, int y, std::string_view text, const Rgb& colour) {
    for (const char character : text) {
        const Glyph& glyph = glyph_of(character);
        const int top = y + drop_of(character) * scale_;
        for (int row = 0; row < glyph_height_px; ++row) {
            for (int column = 0; column < glyph_width_px; ++column) {
                if ((glyph[static_cast<std::size_t>(row)] >> (glyph_width_px - 1 - column) & 1) !=
                    0) {
                    fill({x + column * scale_, top + row * scale_, scale_, scale_}, colour);
                }
            }
        }
        x += advance_px * scale_;
    }
}

void Lettering::write_label(int x, int y, std::string_view text) {
    const int margin = 3 * scale_;
    fill({x, y, width_of(text) + 2 * margin, (glyph_height_px + 1) * scale_ + 2 * margin}, paper,
         0.85);
    write(x + margin, y + margin, text, ink);
}

int Lettering::width_of(std::string_view text) const {
    return text.empty() ? 0 : (advance_px * static_cast<int>(text.size()) - 1) * scale_;
}

}  // namespace quartic::cli
