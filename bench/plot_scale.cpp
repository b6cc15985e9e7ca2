// Scales of plots.
#include "bench/plot_scale.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

namespace quartic {
namespace {

constexpr int linear_ticks = 6;
constexpr double decades_with_more_ticks = 2.5;

// The step of 1, 2 or 5 times a power of ten that cuts a length into about so many pieces.
double round_step(double length, int pieces) {
    const double rough = length / pieces;
    const double power = std::pow(10.0, std::floor(std::log10(rough)));
    for (const double factor : {1.0, 2.0, 5.0}) {
        if (rough <= factor * power) {
            return factor * power;
        }
    }
    return 10.0 * power;
}

}  // namespace

PlotScale::PlotScale(const std::vector<double>& values, bool logarithmic)
    : logarithmic_(logarithmic) {
    double least = std::numeric_limits<double>::infinity();
    double most = -least;
    for (const double value : values) {
        if (std::isfinite(value) && (!logarithmic || value > 0.0)) {
            least = std::min(least, value);
            most = std::max(most, value);
        }
    }
    if (least > most) {
        least = most = 1.0;
    }
    if (logarithmic) {
        low_ = std::pow(10.0, std::floor(std::log10(least) + 1e-9));
        high_ = std::pow(10.0, std::ceil(std::log10(most) - 1e-9));
        high_ = high_ > low_ ? high_ : 10.0 * low_;
    } else {
        const double length = std::max(most, 0.0) - std::min(least, 0.0);
        const double step = round_step(length > 0.0 ? length : 1.0, linear_ticks);
        low_ = step * std::floor(std::min(least, 0.0) / step);
        high_ = std::max(step * std::ceil(std::max(most, 0.0) / step), low_ + step);
    }
}

bool PlotScale::shows(double value) const {
    return std::isfinite(value) && (!logarithmic_ || value > 0.0);
}

double PlotScale::part(double value) const {
    if (logarithmic_) {
        return std::log10(value / low_) / std::log10(high_ / low_);
    }
    return (value - low_) / (high_ - low_);
}

std::vector<double> PlotScale::ticks() const {
    std::vector<double> places;
    if (!logarithmic_) {
        const double step = round_step(high_ - low_, linear_ticks);
        for (int i = 0; low_ + step * i <= high_ + 1e-9 * step; ++i) {
            places.push_back(low_ + step * i);
        }
        return places;
    }
    const int first = static_cast<int>(std::lround(std::log10(low_)));
    const int last = static_cast<int>(std::lround(std::log10(high_)));
    const bool few = last - first <= decades_with_more_ticks;
    const int stride = std::max(1, (last - first) / 8);
    for (int power = first; power <= last; power += stride) {
        for (const double factor : {1.0, 2.0, 5.0}) {
            const double place = factor * std::pow(10.0, power);
            if ((few || factor == 1.0) && place <= high_ * 1.000001) {
                places.push_back(place);
            }
        }
    }
    return places;
}

std::string tick_text(double value) {
    std::array<char, 32> text{};
    const double size = std::abs(value);
    if (size >= 1e4 && size < 1e6) {
        std::snprintf(text.data(), text.size(), "%gk", value / 1e3);
    } else if (size >= 1e6 && size < 1e9) {
        std::snprintf(text.data(), text.size(), "%gM", value / 1e6);
    } else {
        std::snprintf(text.data(), text.size(), size >= 1e3 ? "%.4g" : "%.3g", value);
    }
    return text.data();
}

}  // namespace quartic
