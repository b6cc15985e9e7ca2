// Compares pictures with the reference; rows are shared out among threads, results added in the
// order of rows.
#include "scene/compare.h"

#include "scene/rows.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace quartic {
namespace {

// Points on a circle of tie_distance_px around a pixel's centre at which the reference is asked
// again.
constexpr int tie_rays = 8;

struct Pixel {
    int x = 0;
    int y = 0;
    std::uint32_t seen = no_index;  // by the picture
};

// Whether a ray less than tie_distance_px away sees what the picture shows.
bool is_tie(const Reference& reference, const View& view, const Pixel& pixel) {
    for (int i = 0; i < tie_rays; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / tie_rays;
        const double x = pixel.x + 0.5 + tie_distance_px * std::cos(angle);
        const double y = pixel.y + 0.5 + tie_distance_px * std::sin(angle);
        if (reference.trace(pixel_ray(view, x, y)).part == pixel.seen) {
            return true;
        }
    }
    return false;
}

// Whether the part that the picture shows is as near as the nearest one: within a hundredth of a
// pixel's footprint.
bool is_equal_depth(const Reference& reference, const View& view, const f64::Ray& ray,
                    std::uint32_t seen, double nearest) {
    const ReferenceHit hit = reference.trace_part(ray, seen);
    const double footprint =
        view.step * (view.projection == Projection::perspective ? nearest : 1.0);
    return hit.part != no_index && std::abs(hit.t - nearest) <= tie_distance_px * footprint;
}

void compare_row(const Reference& reference, const View& view, const Picture& picture, int y,
                 Comparison& into) {
    for (int x = 0; x < picture.size.width; ++x) {
        const std::size_t at = pixel_index(picture.size, x, y);
        const Judged judged = judge(reference, view, picture, x, y);
        const ReferenceHit& truth = judged.truth;
        into.hit_pixels += truth.part != no_index;
        if (judged.verdict == Verdict::nothing || judged.verdict == Verdict::agrees) {
            if (judged.verdict == Verdict::agrees) {
                const double cosine = glm::dot(glm::dvec3(picture.normals[at]), truth.normal);
                const double sine =
                    glm::length(glm::cross(glm::dvec3(picture.normals[at]), truth.normal));
                into.depth_errors.push_back(static_cast<float>(
                    std::abs(static_cast<double>(picture.depth_m[at]) - truth.t) /
                    std::max(std::abs(truth.t), 1e-12)));
                into.normal_errors_deg.push_back(
                    static_cast<float>(std::atan2(sine, cosine) * 180.0 / std::numbers::pi));
            }
            continue;
        }
        HardAndTie& kind = judged.verdict == Verdict::missed      ? into.missed
                           : judged.verdict == Verdict::false_hit ? into.false_hits
                                                                  : into.wrong_id;
        (judged.is_tie ? kind.tie : kind.hard) += 1;
        if (!judged.is_tie && into.wrong_pixels.size() < wrong_pixels_max) {
            into.wrong_pixels.push_back({0, x, y, picture.ids[at], truth.part,
                                         static_cast<double>(picture.depth_m[at]), truth.t});
        }
    }
}

void add(const HardAndTie& from, HardAndTie& into) {
    into.hard += from.hard;
    into.tie += from.tie;
}

}  // namespace

Judged judge(const Reference& reference, const View& view, const Picture& picture, int x, int y) {
    const f64::Ray ray = pixel_ray(view, x + 0.5, y + 0.5);
    const std::uint32_t seen = picture.ids[pixel_index(picture.size, x, y)];
    Judged judged;
    judged.truth = reference.trace(ray);
    const std::uint32_t truth = judged.truth.part;
    if (seen == truth) {
        judged.verdict = seen == no_index ? Verdict::nothing : Verdict::agrees;
        return judged;
    }
    judged.verdict = seen == no_index    ? Verdict::missed
                     : truth == no_index ? Verdict::false_hit
                                         : Verdict::wrong_part;
    judged.is_tie = is_tie(reference, view, {x, y, seen}) ||
                    (judged.verdict == Verdict::wrong_part &&
                     is_equal_depth(reference, view, ray, seen, judged.truth.t));
    return judged;
}

void compare(const Reference& reference, const View& view, const Picture& picture,
             Comparison& into) {
    std::vector<Comparison> rows(static_cast<std::size_t>(picture.size.height));
    for_each_row(picture.size.height, [&](int y) {
        compare_row(reference, view, picture, y, rows[static_cast<std::size_t>(y)]);
    });
    const std::uint64_t view_number = into.views++;
    for (const Comparison& row : rows) {
        into.hit_pixels += row.hit_pixels;
        add(row.missed, into.missed);
        add(row.false_hits, into.false_hits);
        add(row.wrong_id, into.wrong_id);
        for (WrongPixel pixel : row.wrong_pixels) {
            if (into.wrong_pixels.size() < wrong_pixels_max) {
                pixel.view = view_number;
                into.wrong_pixels.push_back(pixel);
            }
        }
        into.depth_errors.insert(into.depth_errors.end(), row.depth_errors.begin(),
                                 row.depth_errors.end());
        into.normal_errors_deg.insert(into.normal_errors_deg.end(), row.normal_errors_deg.begin(),
                                      row.normal_errors_deg.end());
    }
}

ErrorFigures figures(std::vector<float>& errors) {
    if (errors.empty()) {
        return {};
    }
    const auto quantile = [&](double part) {
        const auto index =
            static_cast<std::ptrdiff_t>(part * static_cast<double>(errors.size() - 1));
        std::nth_element(errors.begin(), errors.begin() + index, errors.end());
        return static_cast<double>(errors[static_cast<std::size_t>(index)]);
    };
    return {quantile(0.5), quantile(0.9999), quantile(1.0)};
}

}  // namespace quartic
