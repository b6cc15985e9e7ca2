// Compares pictures with the reference; rows are shared out among threads, results added in the
// order of rows.
#include "scene/compare.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numbers>
#include <thread>

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
        const std::size_t at =
            static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.size.width) +
            static_cast<std::size_t>(x);
        const f64::Ray ray = pixel_ray(view, x + 0.5, y + 0.5);
        const ReferenceHit truth = reference.trace(ray);
        const std::uint32_t seen = picture.ids[at];
        into.hit_pixels += truth.part != no_index;
        if (seen == truth.part) {
            if (seen != no_index) {
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
        HardAndTie& kind = seen == no_index         ? into.missed
                           : truth.part == no_index ? into.false_hits
                                                    : into.wrong_id;
        const bool both = seen != no_index && truth.part != no_index;
        const bool tie = is_tie(reference, view, {x, y, seen}) ||
                         (both && is_equal_depth(reference, view, ray, seen, truth.t));
        (tie ? kind.tie : kind.hard) += 1;
        if (!tie && into.wrong_pixels.size() < wrong_pixels_max) {
            into.wrong_pixels.push_back(
                {0, x, y, seen, truth.part, static_cast<double>(picture.depth_m[at]), truth.t});
        }
    }
}

void add(const HardAndTie& from, HardAndTie& into) {
    into.hard += from.hard;
    into.tie += from.tie;
}

}  // namespace

void compare(const Reference& reference, const View& view, const Picture& picture,
             Comparison& into) {
    std::vector<Comparison> rows(static_cast<std::size_t>(picture.size.height));
    std::atomic<int> next{0};
    const auto work = [&] {
        for (int y = next++; y < picture.size.height; y = next++) {
            compare_row(reference, view, picture, y, rows[static_cast<std::size_t>(y)]);
        }
    };
    std::vector<std::thread> threads;
    for (unsigned i = 1; i < std::max(1u, std::thread::hardware_concurrency()); ++i) {
        threads.emplace_back(work);
    }
    work();
    for (std::thread& thread : threads) {
        thread.join();
    }
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
