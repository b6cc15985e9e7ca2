// A plot as data, and the SVG that shows it.
#pragma once

#include <string>
#include <vector>

namespace quartic {

struct Axis {
    std::string label;
    bool logarithmic = false;  // values that are not positive are then left out
};

struct PlotPoint {
    double x = 0.0;
    double y = 0.0;
};

struct Series {
    std::string name;
    std::vector<PlotPoint> points;
};

// Lines through points; or, where there are categories, horizontal bars: x is the length of a bar,
// y the number of its category, from the top.
struct Plot {
    std::string title;
    std::string caption;  // one line: what was measured, on what
    Axis x;
    Axis y;
    std::vector<std::string> categories;
    std::vector<Series> series;

    bool empty() const { return series.empty(); }
};

// Well-formed XML of a picture 960 units wide, white, without scripts or foreign fonts.
std::string as_svg(const Plot& plot);

}  // namespace quartic
