// A map as a picture: its scale, its colours, its legend and the figures that sum it up.
#pragma once

#include "scene/map.h"

namespace quartic {

// Of the pixels that have a number; all 0 where none has.
struct MapFigures {
    std::uint64_t count = 0;
    double min = 0.0;
    double mean = 0.0;
    double max = 0.0;
    double p99 = 0.0;  // 99 of 100 pixels are at most that
};
MapFigures figures_of(const Map& map);

// What the ends of the colour bar stand for.
struct MapScale {
    double low = 0.0;
    double high = 1.0;
    bool logarithmic = false;
};
// Counts from 0 to the 99th percentile, what is more having the last colour; metres over whole
// powers of ten, all but the smallest hundredth of them.
MapScale scale_of(const Map& map);
// 0 to 1.
double place_on(const MapScale& scale, double value);

constexpr Rgb map_background{238, 238, 238};

// RGBA, rows from the bottom up.
std::vector<std::uint8_t> colours_of(const Map& map, const MapScale& scale);

struct LegendTick {
    double place = 0.0;  // on the bar, 0 to 1
    std::string text;
};
struct LegendLine {
    Rgb colour;
    std::string text;
};
struct Legend {
    std::string title;              // with the unit
    std::vector<LegendTick> ticks;  // none: there is no bar
    std::vector<LegendLine> lines;  // the classes that the map may have, with their pixels
};
Legend legend_of(const Map& map, const MapScale& scale);

}  // namespace quartic
