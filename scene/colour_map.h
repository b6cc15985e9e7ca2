// Colours for numbers and for kinds of things, as the maps of a picture have them.
#pragma once

#include <cstddef>
#include <cstdint>

namespace quartic {

// sRGB, eight bits each.
struct Rgb {
    std::uint8_t red = 0;
    std::uint8_t green = 0;
    std::uint8_t blue = 0;
    bool operator==(const Rgb&) const = default;
};

// From 0 (dark violet) to 1 (yellow), equal steps looking equally large; lightness only grows.
Rgb heat_colour(double unit);

// Colours that differ in hue and lightness, for kinds without an order; they repeat.
constexpr std::size_t kind_colours = 12;
Rgb kind_colour(std::size_t index);

// On dark colours white can be read, on light ones black.
bool is_dark(const Rgb& colour);

}  // namespace quartic
