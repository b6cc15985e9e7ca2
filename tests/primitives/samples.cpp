// The sample shapes.
#include "tests/primitives/samples.h"

#include <numbers>

namespace quartic::test {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

}  // namespace

template <>
std::vector<f64::Sphere> samples<f64::Sphere>() {
    return {{1.0, 0, 0, 0}, {0.003, 0, 0, 0}, {250.0, 0, 0, 0}};
}

template <>
std::vector<f64::Dish> samples<f64::Dish>() {
    return {{1.0, 0.5, 0, 0},  {1.0, 1.0, 0, 0}, {1.0, 1.7, 0, 0}, {1.0, 0.01, 0, 0},
            {1.0, 0.3, 1, 0},  {1.0, 1.0, 1, 0}, {1.0, 1.8, 1, 0}, {0.3, 2.0, 1, 0},
            {0.5, 0.05, 1, 0}, {20.0, 5.0, 0, 0}};
}

template <>
std::vector<f64::Cylinder> samples<f64::Cylinder>() {
    return {{0.5, 2.0, 0, 0}, {0.01, 30.0, 0, 0}, {5.0, 0.002, 0, 0}, {1.0, 1.0, 0, 0}};
}

template <>
std::vector<f64::Cone> samples<f64::Cone>() {
    return {{1.0, 0.5, 2.0, 0},  {0.2, 0.9, 0.3, 0}, {1.0, 0.0, 1.0, 0},      {0.0, 1.0, 3.0, 0},
            {1.0, 0.0, 0.01, 0}, {0.5, 0.5, 1.0, 0}, {0.5, 0.500001, 1.0, 0}, {3.0, 0.01, 40.0, 0}};
}

template <>
std::vector<f64::Snout> samples<f64::Snout>() {
    return {{0.5, 0.3, 1.0, 0.2, 0, 0, 0, 0},       // eccentric
            {0.5, 0.3, 1.0, -0.2, 0, 0, 0, 0},      // leaning the other way
            {0.5, 0.5, 1.0, 0.4, 0, 0, 0, 0},       // oblique cylinder
            {0.5, 0.5, 1.0, 0.0, 0.3, 0, 0, 0},     // sheared below
            {0.5, 0.5, 1.0, 0.0, 0, 0, 0.2, -0.4},  // sheared above
            {0.5, 0.5, 2.0, 0.0, -0.4, 0.3, 0.4, 0.2},
            {0.5, 0.2, 1.5, 0.1, 0.3, 0.2, -0.3, 0.5},  // everything at once
            {0.2, 0.6, 1.5, -0.3, 0.3, -0.2, -0.3, 0.1},
            {0.5, 0.0, 1.0, 0.3, 0, 0, 0, 0},  // a leaning tip
            {0.0, 0.5, 1.0, 0.9, 0, 0, 0.2, 0.1},
            {0.5, 0.0, 1.0, 0.0, 0.7, 0.0, 0, 0},
            {0.1, 0.1, 8.0, 0.0, 1.0, 0.0, -1.0, 0.0},  // 45 degree mitres
            {2.0, 1.9999, 0.4, 0.1, 0.05, 0.02, 0.0, 0.05},
            {0.3, 0.3, 0.3, 0.0, 0.5, 0.0, -0.5, 0.0}};  // a gore that is thinnest at nothing
}

template <>
std::vector<f64::Torus> samples<f64::Torus>() {
    std::vector<f64::Torus> all;
    for (const double ratio : {1.0, 1.0001, 1.2, 1.5, 2.66, 10.0, 62.0, 400.0}) {
        for (const double arc_deg :
             {1.0, 30.0, 90.0, 135.0, 180.0, 200.0, 270.0, 300.0, 359.0, 360.0}) {
            all.push_back(
                {0.1 * ratio, 0.1, arc_deg == 360.0 ? 360.0 * degree : arc_deg * degree, 0});
        }
    }
    return all;
}

template <>
std::vector<f64::RectangularTorus> samples<f64::RectangularTorus>() {
    std::vector<f64::RectangularTorus> all;
    for (const double arc_deg : {2.0, 45.0, 90.0, 180.0, 181.0, 270.0, 350.0, 360.0}) {
        all.push_back({0.5, 1.0, 0.4, arc_deg * degree});
        all.push_back({0.0, 1.0, 0.2, arc_deg * degree});
    }
    all.push_back({0.5, 1.0, 0.0, 100.0 * degree});
    all.push_back({9.99, 10.0, 1.0, 100.0 * degree});
    return all;
}

template <>
std::vector<f64::Box> samples<f64::Box>() {
    return {{1.0, 2.0, 3.0, 0},
            {0.001, 10.0, 0.3, 0},
            {0, 1.0, 2.0, 0},
            {1.0, 0, 2.0, 0},
            {1.0, 2.0, 0, 0}};
}

template <>
std::vector<f64::Pyramid> samples<f64::Pyramid>() {
    return {{1.0, 1.0, 0.5, 0.5, 0, 0, 1.0, 0},      {1.0, 1.0, 0, 0, 0, 0, 1.0, 0},
            {1.0, 0.5, 0.2, 0.7, 0.3, -0.4, 1.0, 0}, {1.0, 1.0, 0, 1.0, 0, 0, 1.0, 0},
            {0, 0, 1.0, 2.0, 0.5, 0.5, 0.7, 0},      {1.0, 0, 0, 1.0, 0, 0, 1.0, 0},
            {0.5, 0.5, 0.5, 0.5, 1.5, 0, 1.0, 0},    {2.0, 3.0, 1.0, 1.0, 0, 0, 0.01, 0}};
}

// The plane curve y^2 = x^3 + x^2 turned into surfaces: a node at the origin.
template <>
std::vector<f64::CubicSurface> samples<f64::CubicSurface>() {
    f64::CubicSurface ding_dong{};  // x^2 + y^2 = (1 - z) z^2
    ding_dong.c[0] = {0.0, 0.0, 0.0, 1.0};
    ding_dong.c[3] = {0.0, 0.0, 1.0, 0.0};
    ding_dong.c[4] = {1.0, -1.0, 0.0, 0.0};
    ding_dong.half_size = 1.0;
    f64::CubicSurface small = ding_dong;
    small.half_size = 0.02;
    return {ding_dong, small};
}

template <>
std::vector<f64::QuarticSurface> samples<f64::QuarticSurface>() {
    // Goursat's x^4 + y^4 + z^4 - x^2 - y^2 - z^2 + 3/8.
    f64::QuarticSurface cushion{};
    cushion.c[0].x = 1.0;
    cushion.c[2].y = -1.0;
    cushion.c[5].x = 1.0;
    cushion.c[6].y = -1.0;
    cushion.c[7].z = 1.0;
    cushion.c_32 = -1.0;
    cushion.c_34 = 0.375;
    cushion.half_size = 1.0;
    f64::QuarticSurface large = cushion;
    large.half_size = 40.0;
    return {cushion, large};
}

template <>
std::vector<f64::Disk> samples<f64::Disk>() {
    return {{1.0, 0.0, 0, 0}, {1.0, 0.5, 0, 0}, {0.2, 0.199, 0, 0}};
}

}  // namespace quartic::test
