// A font of five by seven pixels, for letters in pictures.
#pragma once

#include <array>
#include <cstdint>

namespace quartic::cli {

constexpr int glyph_width_px = 5;
constexpr int glyph_height_px = 7;

// Rows from the top; bit 4 is the leftmost pixel.
using Glyph = std::array<std::uint8_t, glyph_height_px>;

// A frame for what the font does not have.
const Glyph& glyph_of(char character);
// How far it hangs below the line, in pixels.
int drop_of(char character);

}  // namespace quartic::cli
