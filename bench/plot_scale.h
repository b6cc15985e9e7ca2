// Maps values to places along an axis, and chooses its ticks.
#pragma once

#include <string>
#include <vector>

namespace quartic {

class PlotScale {
public:
    // From the values that will be shown; those a logarithm cannot take are left out. Linear scales
    // start at zero.
    PlotScale(const std::vector<double>& values, bool logarithmic);

    bool shows(double value) const;
    double part(double value) const;  // 0 at the low end, 1 at the high end
    std::vector<double> ticks()
        const;  // 1, 2, 5 times powers of ten; only powers of ten where long

private:
    double low_ = 0.0;
    double high_ = 1.0;
    bool logarithmic_ = false;
};

// "0.002", "16k", "1e-07".
std::string tick_text(double value);

}  // namespace quartic
