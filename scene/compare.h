// Compares a picture's ids, depths and normals with the reference, pixel by pixel.
#pragma once

#include "scene/reference.h"

#include <cstdint>
#include <span>
#include <vector>

namespace quartic {

// What a renderer found, rows from the bottom up.
struct Picture {
    PixelSize size;
    std::span<const std::uint32_t> ids;
    std::span<const float> depth_m;
    std::span<const glm::vec3> normals;
};

struct HardAndTie {
    std::uint64_t hard = 0;
    std::uint64_t tie = 0;  // within tie_distance_px of an edge, or of equal depth
};
constexpr double tie_distance_px = 0.01;

struct ErrorFigures {
    double median = 0.0;
    double p9999 = 0.0;
    double max = 0.0;
};

// A hard wrong pixel, counted from the lower left.
struct WrongPixel {
    std::uint64_t view = 0;
    int x = 0;
    int y = 0;
    std::uint32_t seen = no_index;   // part in the picture
    std::uint32_t truth = no_index;  // part that the reference hits
    double seen_depth_m = 0.0;
    double true_depth_m = 0.0;
};
constexpr std::size_t wrong_pixels_max = 16;

struct Comparison {
    std::uint64_t views = 0;
    std::uint64_t hit_pixels = 0;  // where the reference hits
    HardAndTie missed;
    HardAndTie false_hits;
    HardAndTie wrong_id;
    std::vector<float> depth_errors;  // relative, where both hit the same part
    std::vector<float> normal_errors_deg;
    std::vector<WrongPixel> wrong_pixels;  // the first ones
};

// What the reference says of one pixel.
enum class Verdict : std::uint8_t { nothing, agrees, missed, false_hit, wrong_part };
struct Judged {
    Verdict verdict = Verdict::nothing;  // nothing: neither hits
    bool is_tie = false;                 // of what is wrong
    ReferenceHit truth;
};
Judged judge(const Reference& reference, const View& view, const Picture& picture, int x, int y);

void compare(const Reference& reference, const View& view, const Picture& picture,
             Comparison& into);
ErrorFigures figures(std::vector<float>& errors);

}  // namespace quartic
