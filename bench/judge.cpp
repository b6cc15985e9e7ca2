// Compares what shaders found along their rays with the truth.
#include "bench/judge.h"

#include "scene/rows.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace quartic {
namespace {

// Points on a circle around the pixel's centre at which the truth is asked again.
constexpr int tie_rays = 8;
constexpr int block_width = 8;
constexpr int block_height = 4;
constexpr double nowhere = std::numeric_limits<double>::infinity();
constexpr float missed_t = -1e17f;  // shaders write -1e18 for a miss

std::size_t index_of(PixelSize size, int x, int y) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width) +
           static_cast<std::size_t>(x);
}

// Several fragments of one pixel solve the same ray.
std::uint64_t steps_of_ray(const GBuffer& picture, std::size_t at) {
    const std::uint64_t rays = std::max<std::uint64_t>(1, picture.rays[at]);
    return (picture.steps[at] + rays - 1) / rays;
}

void add(const HardAndTie& from, HardAndTie& into) {
    into.hard += from.hard;
    into.tie += from.tie;
}

double quotient(std::uint64_t sum, std::uint64_t count) {
    return count == 0 ? 0.0 : static_cast<double>(sum) / static_cast<double>(count);
}

}  // namespace

Judgement count_rays(const GBuffer& picture) {
    Judgement into;
    for (std::size_t i = 0; i < picture.rays.size(); ++i) {
        into.rays += picture.rays[i];
        into.steps += picture.steps[i];
        into.covered += picture.rays[i] > 0;
        into.steps_max = std::max(into.steps_max, steps_of_ray(picture, i));
    }
    for (int top = 0; top < picture.size.height; top += block_height) {
        for (int left = 0; left < picture.size.width; left += block_width) {
            bool any = false;
            std::uint64_t most = 0;
            for (int y = top; y < std::min(top + block_height, picture.size.height); ++y) {
                for (int x = left; x < std::min(left + block_width, picture.size.width); ++x) {
                    const std::size_t at = index_of(picture.size, x, y);
                    any = any || picture.rays[at] > 0;
                    most = std::max(most, steps_of_ray(picture, at));
                }
            }
            into.blocks += any;
            into.steps_of_blocks += most;
        }
    }
    return into;
}

double Judgement::steps_mean() const {
    return quotient(steps, rays);
}

double Judgement::steps_mean_of_blocks() const {
    return quotient(steps_of_blocks, blocks);
}

double Judgement::waste() const {
    return covered == 0 ? 0.0 : 1.0 - quotient(std::min(hits, covered), covered);
}

void add(const Judgement& from, Judgement& into) {
    into.covered += from.covered;
    into.hits += from.hits;
    add(from.missed, into.missed);
    add(from.false_hits, into.false_hits);
    add(from.elsewhere, into.elsewhere);
    into.errors.insert(into.errors.end(), from.errors.begin(), from.errors.end());
    into.rays += from.rays;
    into.steps += from.steps;
    into.steps_max = std::max(into.steps_max, from.steps_max);
    into.blocks += from.blocks;
    into.steps_of_blocks += from.steps_of_blocks;
}

Judge::Judge(Crossings crossings, const View& view, double length, double far_apart)
    : crossings_(std::move(crossings)),
      view_(view),
      length_(Long(length)),
      far_apart_(Long(far_apart)) {
    pixels_.resize(index_of(view.size, 0, view.size.height));
}

Judgement Judge::judge(const GBuffer& picture) {
    std::vector<Judgement> rows(static_cast<std::size_t>(picture.size.height));
    for_each_row(picture.size.height,
                 [&](int y) { judge_row(picture, y, rows[static_cast<std::size_t>(y)]); });
    Judgement sum = count_rays(picture);
    for (const Judgement& row : rows) {
        add(row, sum);
    }
    return sum;
}

// The floats of the shader; where no ray was cast, the ray that should have been.
LongRay Judge::ray_of(const GBuffer& picture, int x, int y) const {
    const std::size_t at = index_of(picture.size, x, y);
    if (picture.rays[at] > 0) {
        const glm::vec4& origin = picture.ray_origins[at];
        return {LongVector(origin), LongVector(picture.ray_directions[at]), Long(origin.w)};
    }
    const f64::Ray ray = pixel_ray(view_, x + 0.5, y + 0.5);
    return {LongVector(ray.origin), LongVector(ray.direction), Long(ray.first)};
}

// The ray through a point so many pixels aside.
LongRay Judge::moved(const LongRay& ray, double dx, double dy) const {
    const LongVector aside =
        Long(view_.step) * (Long(dx) * LongVector(view_.right) + Long(dy) * LongVector(view_.up));
    LongRay result = ray;
    if (view_.projection == Projection::orthographic) {
        result.origin += aside;
        return result;
    }
    const Long depth = -glm::dot(ray.origin - LongVector(view_.eye), LongVector(view_.back));
    result.origin += depth * aside;
    result.direction += aside;
    return result;
}

void Judge::look_beside(const LongRay& ray, Pixel& pixel) const {
    for (int i = 0; i < tie_rays; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / tie_rays;
        const RealRoots truth = crossings_(
            moved(ray, tie_distance_px * std::cos(angle), tie_distance_px * std::sin(angle)));
        pixel.beside.push_back(truth.count > 0 ? static_cast<double>(truth.t[0]) : nowhere);
    }
}

bool Judge::is_tie(const Answer& answer, const Pixel& pixel) const {
    const Long speed = glm::length(answer.ray.direction);
    return std::any_of(pixel.beside.begin(), pixel.beside.end(), [&](double t) {
        return t == nowhere ? !answer.found
                            : answer.found && std::abs(Long(t) - answer.t) * speed <= far_apart_;
    });
}

void Judge::judge_row(const GBuffer& picture, int y, Judgement& into) {
    for (int x = 0; x < picture.size.width; ++x) {
        const std::size_t at = index_of(picture.size, x, y);
        const bool cast = picture.rays[at] > 0;
        const glm::vec4 direction = cast ? picture.ray_directions[at] : glm::vec4(0.0f);
        const glm::vec4 origin = cast ? picture.ray_origins[at] : glm::vec4(0.0f);
        Answer answer{ray_of(picture, x, y), cast && !(direction.w < missed_t), Long(direction.w)};

        Pixel& pixel = pixels_[at];
        const bool same = pixel.known && pixel.origin == origin &&
                          glm::vec3(pixel.direction) == glm::vec3(direction);
        if (!same) {
            const RealRoots truth = crossings_(answer.ray);
            pixel = {origin, direction, true, truth.count > 0, truth.t[0], {}};
        }
        into.hits += pixel.hits;
        if (pixel.hits && answer.found) {
            const Long off = std::abs(answer.t - pixel.t) * glm::length(answer.ray.direction);
            if (off <= far_apart_) {
                into.errors.push_back(static_cast<float>(off / length_));
                continue;
            }
        }
        if (pixel.hits || answer.found) {
            HardAndTie& kind = !answer.found ? into.missed
                               : !pixel.hits ? into.false_hits
                                             : into.elsewhere;
            if (pixel.beside.empty()) {
                look_beside(answer.ray, pixel);
            }
            (is_tie(answer, pixel) ? kind.tie : kind.hard) += 1;
        }
    }
}

}  // namespace quartic
