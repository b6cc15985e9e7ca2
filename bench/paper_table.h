// Table 1 of R. de Toledo, B. Levy, J.-C. Paul 2007, "Iterative methods for visualization of
// implicit surfaces on GPU" (ISVC 2007): one torus, r = 0.3, R = 0.7, filling 1024x1024 pixels, on
// a GeForce 7900.
#pragma once

#include <array>
#include <span>
#include <string_view>

namespace quartic {

constexpr std::array<int, 6> paper_angles_deg = {0, 18, 36, 54, 72, 90};

struct PaperRow {
    std::string_view name;      // as printed
    std::string_view method;    // what it is called here
    std::array<double, 6> fps;  // by angle
    double fps_mean;
    double error_micro_r;      // of the tube's radius, in millionths
    double error_micro_total;  // of R + r
    // Frames a second times pixels of the box: average, standard deviation, and that in per cent.
    // 0: not printed.
    double megapixels_per_second;
    double megapixels_stddev;
    double megapixels_stddev_pct;
};

constexpr std::array<PaperRow, 11> paper_rows = {{
    {"Sturm", "sturm", {68, 68, 71, 82, 108, 163}, 93, 25, 11, 35.07, 0.485, 1.38},
    {"D.D. Bisection",
     "double_derivative_bisection",
     {15, 15, 16, 19, 25, 46},
     23,
     1400,
     600,
     8.24,
     0.631,
     7.65},
    {"Sphere Tracing",
     "sphere_tracing",
     {16, 16, 16, 20, 27, 46},
     24,
     1000,
     429,
     8.60,
     0.527,
     6.14},
    {"2-rays S. Tracing",
     "sphere_tracing_two_ray",
     {66, 66, 65, 80, 100, 153},
     88,
     1000,
     429,
     33.30,
     1.111,
     3.34},
    {"Newton 0.00003",
     "newton_fine",
     {246, 254, 261, 302, 380, 537},
     330,
     30,
     13,
     125.86,
     6.587,
     5.23},
    {"Newton 0.001", "newton", {267, 283, 291, 324, 410, 590}, 361, 1000, 429, 137.72, 7.654, 5.56},
    {"Polygon 32*32",
     "polygon_32",
     {2653, 2649, 2668, 2704, 2730, 2744},
     2691,
     11236,
     4815,
     0,
     0,
     0},
    {"Polygon 64*64",
     "polygon_64",
     {1238, 1238, 1238, 1238, 1238, 1238},
     1238,
     2811,
     1205,
     0,
     0,
     0},
    {"Polygon 128*128", "polygon_128", {369, 369, 369, 369, 369, 369}, 369, 703, 301, 0, 0, 0},
    {"Polygon 256*256", "polygon_256", {96, 96, 96, 96, 96, 96}, 96, 176, 75, 0, 0, 0},
    {"Polygon 512*512", "polygon_512", {24, 24, 24, 24, 24, 24}, 24, 44, 19, 0, 0, 0},
}};

constexpr std::array<double, 6> paper_box_kilopixels = {524, 516, 495, 430, 324, 209};
constexpr std::array<double, 6> paper_torus_kilopixels = {312, 305, 285, 256, 203, 146};
constexpr std::array<double, 6> paper_waste_pct = {40.4, 40.9, 42.2, 40.5, 37.3, 29.8};

}  // namespace quartic
