// Interpolates colours between anchors.
#include "scene/colour_map.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace quartic {
namespace {

// Eleven colours of viridis at equal distances (van der Walt, Smith, Firing 2015, matplotlib, CC0);
// between them straight lines, which stay within a few steps of 255 of the original.
constexpr std::array<Rgb, 11> heat{{{68, 1, 84},
                                    {72, 36, 117},
                                    {65, 68, 135},
                                    {53, 95, 141},
                                    {42, 120, 142},
                                    {33, 145, 140},
                                    {34, 168, 132},
                                    {68, 191, 112},
                                    {122, 209, 81},
                                    {189, 223, 38},
                                    {253, 231, 37}}};

// The first seven after Okabe and Ito (2008, Color Universal Design), without their black; the
// others fill gaps of hue and lightness between those.
constexpr std::array<Rgb, kind_colours> kinds{{{0, 114, 178},
                                               {213, 94, 0},
                                               {0, 158, 115},
                                               {230, 159, 0},
                                               {204, 121, 167},
                                               {86, 180, 233},
                                               {240, 228, 66},
                                               {110, 50, 130},
                                               {130, 20, 30},
                                               {150, 110, 70},
                                               {20, 70, 50},
                                               {250, 170, 190}}};

std::uint8_t between(std::uint8_t from, std::uint8_t to, double part) {
    return static_cast<std::uint8_t>(std::lround(from + part * (to - from)));
}

}  // namespace

Rgb heat_colour(double unit) {
    constexpr double last = heat.size() - 1;
    const double at = std::clamp(unit, 0.0, 1.0) * last;
    const double first = std::min(std::floor(at), last - 1.0);
    const Rgb& from = heat[static_cast<std::size_t>(first)];
    const Rgb& to = heat[static_cast<std::size_t>(first) + 1];
    const double part = at - first;
    return {between(from.red, to.red, part), between(from.green, to.green, part),
            between(from.blue, to.blue, part)};
}

Rgb kind_colour(std::size_t index) {
    return kinds[index % kinds.size()];
}

bool is_dark(const Rgb& colour) {
    return 0.2126 * colour.red + 0.7152 * colour.green + 0.0722 * colour.blue < 128.0;
}

}  // namespace quartic
