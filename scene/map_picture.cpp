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

MapScale logarithmic_scale(const std::vector<float>& numbers) {
    double least = 1e300;
    double most = 0.0;
    for (const float number : numbers) {
        if (number > 0.0f) {
            least = std::min(least, static_cast<double>(number));
            most = std::max(most, static_cast<double>(number));
        }
    }
    if (most == 0.0) {
        return {1e-9, 1e-6, true};
    }
    const double high = std::ceil(std::log10(most));
    const double low = std::clamp(std::floor(std::log10(least)), high - decades_max, high - 1.0);
    return {std::pow(10.0, low), std::pow(10.0, high), true};
}

std::string short_text(double value) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.3g", value);
    return text.data();
}

// At most so many that their texts stand apart.
std::vector<LegendTick> ticks_of(const MapScale& scale, double max) {
    std::vector<LegendTick> ticks;
    if (scale.logarithmic) {
        const double decades = std::round(std::log10(scale.high / scale.low));
        const double step = decades > 4.0 ? 2.0 : 1.0;
        for (double decade = decades; decade >= 0.0; decade -= step) {
            ticks.push_back({decade / decades, short_text(scale.low * std::pow(10.0, decade))});
        }
        std::reverse(ticks.begin(), ticks.end());
        return ticks;
    }
    const std::string last = short_text(scale.high) + (max > scale.high ? "+" : "");
    return {{0.0, short_text(scale.low)},
            {0.5, short_text(0.5 * (scale.low + scale.high))},
            {1.0, last}};
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
    const auto rank = static_cast<std::ptrdiff_t>((numbers.size() * 99 + 99) / 100 - 1);
    std::nth_element(numbers.begin(), numbers.begin() + rank, numbers.end());
    figures.p99 = static_cast<double>(numbers[static_cast<std::size_t>(rank)]);
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
        legend.title += ", " + std::string(row.unit) + (scale.logarithmic ? "" : " per pixel");
        legend.ticks = ticks_of(scale, figures_of(map).max);
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
