// Letters and filled boxes in pictures.
#pragma once

#include "scene/camera.h"
#include "scene/colour_map.h"

#include <cstdint>
#include <string_view>
#include <vector>

namespace quartic::cli {

// Draws into a picture; x and y count from its upper left corner, and what lies outside is cut off.
class Lettering {
public:
    // RGBA, rows from the bottom up; every pixel of the font becomes scale x scale pixels.
    Lettering(std::vector<std::uint8_t>& rgba, PixelSize size, int scale)
        : rgba_(rgba), size_(size), scale_(scale) {}

    struct Area {
        int x = 0;
        int y = 0;
        int width = 0;
        int height = 0;
    };
    void fill(const Area& area, const Rgb& colour, double opacity = 1.0);
    void write(int x, int y, std::string_view text, const Rgb& colour);
    // Black on light, on a bright strip around the text.
    void write_label(int x, int y, std::string_view text);

    int width_of(std::string_view text) const;
    int line_height() const { return 11 * scale_; }
    int scale() const { return scale_; }
    PixelSize size() const { return size_; }

private:
    std::vector<std::uint8_t>& rgba_;
    PixelSize size_;
    int scale_;
};

}  // namespace quartic::cli
