// Sums maps up and colours them.
#include "scene/map_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numeric>

namespace quartic {
namespace {

constexpr double decades_max = 8.0;

std::vector<float> numbers_of(const Map& map) {
    std::vector<float> numbers;
    std::copy_if(map.values.begin(), map.values.end(), std::back_inserter(numbers),
                 [](float value) { return std::isfinite(value); });
    return numbers;
}

// The value that so large a part of the numbers is at most.
double quantile(std::vector<float>& numbers, double part) {
    const auto rank =
        static_cast<std::ptrdiff_t>(std::ceil(part * static_cast<double>(numbers.size())) - 1.0);
    std::nth_element(numbers.begin(), numbers.begin() + rank, numbers.end());
    return static_cast<double>(numbers[static_cast<std::size_t>(rank)]);
}

// Up to the largest number; down to where all but one in a hundred are.
MapScale logarithmic_scale(std::vector<float> numbers) {
    std::erase_if(numbers, [](float number) { return number <= 0.0f; });
    if (numbers.empty()) {
        return {1e-9, 1e-6, true};
    }
    const double high = std::ceil(std::log10(quantile(numbers, 1.0)));
    const double least = std::floor(std::log10(quantile(numbers, 0.01)));
    const double low = std::clamp(least, high - decades_max, high - 1.0);
    return {std::pow(10.0, low), std::pow(10.0, high), true};
}

std::string short_text(double value) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.3g", value);
    return text.data();
}

// Powers of ten, at most so many that their texts stand apart.
std::vector<LegendTick> decade_ticks(const MapScale& scale) {
    const int low = static_cast<int>(std::lround(std::log10(scale.low)));
    const int high = static_cast<int>(std::lround(std::log10(scale.high)));
    const int step = high - low > 4 ? 2 : 1;
    std::vector<LegendTick> ticks;
    for (int decade = high; decade >= low; decade -= step) {
        ticks.insert(ticks.begin(), {static_cast<double>(decade - low) / (high - low),
                                     "1e" + std::to_string(decade)});
    }
    return ticks;
}

// The ends and the middle; whole numbers if the ends are.
std::vector<LegendTick> count_ticks(const MapScale& scale, double max) {
    std::vector<LegendTick> ticks{{0.0, short_text(scale.low)}};
    const double middle = std::floor(0.5 * (scale.low + scale.high));
    if (middle > scale.low) {
        ticks.push_back({place_on(scale, middle), short_text(middle)});
    }
    ticks.push_back({1.0, short_text(scale.high) + (max > scale.high ? "+" : "")});
    return ticks;
}

}  // namespace

MapFigures figures_of(const Map& map) {
    std::vector<float> numbers = numbers_of(map);
    MapFigures figures;
    if (numbers.empty()) {
        return figures;
    }
    figures.count = numbers.size();
    const auto [least, most] = std::minmax_element(numbers.begin(), numbers.end());
    figures.min = static_cast<double>(*least);
    figures.max = static_cast<double>(*most);
    figures.mean =
        std::accumulate(numbers.begin(), numbers.end(), 0.0) / static_cast<double>(numbers.size());
    figures.p99 = quantile(numbers, 0.99);
    return figures;
}

MapScale scale_of(const Map& map) {
    switch (map.kind) {
        case MapKind::steps:
        case MapKind::rays: return {0.0, std::max(1.0, figures_of(map).p99), false};
        case MapKind::error:
        case MapKind::difference: return logarithmic_scale(numbers_of(map));
        case MapKind::solver: break;
    }
    return {};
}

double place_on(const MapScale& scale, double value) {
    const double place = scale.logarithmic ? std::log(std::max(value, scale.low) / scale.low) /
                                                 std::log(scale.high / scale.low)
                                           : (value - scale.low) / (scale.high - scale.low);
    return std::clamp(place, 0.0, 1.0);
}

std::vector<std::uint8_t> colours_of(const Map& map, const MapScale& scale) {
    std::vector<std::uint8_t> rgba;
    rgba.reserve(4 * map.values.size());
    for (std::size_t i = 0; i < map.values.size(); ++i) {
        Rgb colour = map_background;
        if (map.classes[i] != 0) {
            colour = map.class_list[map.classes[i] - 1u].colour;
        } else if (std::isfinite(map.values[i])) {
            colour = heat_colour(place_on(scale, static_cast<double>(map.values[i])));
        }
        rgba.insert(rgba.end(), {colour.red, colour.green, colour.blue, 255});
    }
    return rgba;
}

Legend legend_of(const Map& map, const MapScale& scale) {
    const MapRow& row = row_of(map.kind);
    Legend legend;
    legend.title = std::string(row.title);
    if (map.kind != MapKind::solver) {
        legend.title += scale.logarithmic ? ", " + std::string(row.unit) : "";
        legend.ticks =
            scale.logarithmic ? decade_ticks(scale) : count_ticks(scale, figures_of(map).max);
    }
    for (const MapClass& one : map.class_list) {
        // Solvers that draw nothing here need no line.
        if (one.count > 0 || map.kind != MapKind::solver) {
            legend.lines.push_back({one.colour, one.text + ": " + std::to_string(one.count)});
        }
    }
    return legend;
}

}  // namespace quartic
