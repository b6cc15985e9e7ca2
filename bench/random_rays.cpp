// Chooses rays, asks the solver and the truth.
#include "bench/random_rays.h"

#include "generators/random.h"
#include "scene/rows.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace quartic {
namespace {

constexpr Long infinity = std::numeric_limits<Long>::infinity();
constexpr std::uint64_t rays_per_row = 4096;  // that share a seed
constexpr double turn = 2.0 * std::numbers::pi;

double logarithmic(Random& random, double low, double high) {
    return std::exp(random.between(std::log(low), std::log(high)));
}

f32::Torus random_torus(Random& random, const RayTrialOptions& options) {
    double ratio = options.ratio;
    if (ratio == 0.0) {
        ratio = logarithmic(random, 0.05, options.arcs ? 1.0 : 5.0);
    }
    const double arc = options.arcs ? random.between(1.0, 359.0) / 360.0 * turn : turn;
    return {1.0f, static_cast<float>(ratio), static_cast<float>(arc), 0.0f};
}

// A point of the tube's surface, or inside by a part of its radius.
glm::dvec3 on_tube(Random& random, const f32::Torus& torus, double part) {
    const double angle = random.between(0.0, static_cast<double>(torus.arc));
    const double around = random.between(0.0, turn);
    const double radius = part * static_cast<double>(torus.radius);
    const double rho = static_cast<double>(torus.bend_radius) + radius * std::cos(around);
    return {rho * std::cos(angle), rho * std::sin(angle), radius * std::sin(around)};
}

// A line along a tangent of the surface at a point.
f64::Ray grazing_ray(Random& random, const f32::Torus& torus) {
    const f64::Torus exact{static_cast<double>(torus.bend_radius),
                           static_cast<double>(torus.radius), static_cast<double>(torus.arc), 0.0};
    const glm::dvec3 point = on_tube(random, torus, 1.0);
    const glm::dvec3 normal = glm::normalize(f64().from_spine(exact, point));
    const glm::dvec3 along = f64().across(normal);
    const double angle = random.between(0.0, turn);
    const glm::dvec3 direction =
        std::cos(angle) * along + std::sin(angle) * glm::cross(normal, along);
    const double beside = logarithmic(random, 1e-9, 0.1) * exact.radius;
    const glm::dvec3 middle = point + (random.chance(0.5) ? beside : -beside) * normal;
    return {middle - 8.0 * direction, direction, 0.0, 0.0};
}

f64::Ray random_ray(Random& random, const f32::Torus& torus, RayKind kind) {
    const double outer = static_cast<double>(torus.bend_radius + torus.radius);
    if (kind == RayKind::grazing) {
        return grazing_ray(random, torus);
    }
    if (kind == RayKind::in_tube) {
        return {on_tube(random, torus, std::sqrt(random.between(0.0, 0.998))),
                random_direction(random), 0.0, 0.0};
    }
    if (kind == RayKind::in_bore) {
        const double bore = std::max(0.0, static_cast<double>(torus.bend_radius - torus.radius));
        const glm::dvec3 eye = 0.99 * bore * random_direction(random);
        return {eye, random_direction(random), 0.0, 0.0};
    }
    const double distance =
        outer * (kind == RayKind::near ? random.between(1.5, 6.0) : logarithmic(random, 6.0, 1e5));
    const glm::dvec3 eye = distance * random_direction(random);
    const glm::dvec3 target =
        outer * std::cbrt(random.between(0.0, 1.0)) * random_direction(random);
    return {eye, glm::normalize(target - eye), 0.0, 0.0};
}

// As the renderer hands rays to its shaders: from near the shape, in floats.
f32::Ray as_drawn(const f64::Ray& ray, double outer) {
    const double middle = -glm::dot(ray.origin, ray.direction);
    const double start = std::max(0.0, middle - 1.1 * outer);
    return {glm::vec3(ray.origin + start * ray.direction), glm::vec3(ray.direction),
            static_cast<float>(-start), 0.0f};
}

// The solid's first boundary at or after the ray's first parameter, infinity for none: its wall
// within the arc, or a cap.
class Truth {
public:
    explicit Truth(const f32::Torus& torus)
        : wall_(crossings_of(torus)),
          bend_radius_(torus.bend_radius),
          radius_(torus.radius),
          arc_(torus.arc),
          ring_(f32().is_ring(torus)) {}

    Long first_hit(const LongRay& ray) const {
        Long nearest = infinity;
        const RealRoots roots = wall_(ray);
        for (int i = 0; i < roots.count; ++i) {
            const Long t = roots.t[static_cast<std::size_t>(i)];
            if (t >= ray.first && is_in_arc(ray.origin + t * ray.direction)) {
                nearest = std::min(nearest, t);
            }
        }
        return ring_ ? nearest : std::min(nearest, first_cap(ray));
    }

private:
    bool is_in_arc(const LongVector& p) const {
        const Long angle = std::atan2(p.y, p.x);
        return ring_ || (angle < 0.0L ? angle + 2.0L * std::numbers::pi_v<Long> : angle) <= arc_;
    }

    Long first_cap(const LongRay& ray) const {
        Long nearest = infinity;
        for (const Long angle : {0.0L, arc_}) {
            const LongVector normal(-std::sin(angle), std::cos(angle), 0.0L);
            const Long rate = glm::dot(normal, ray.direction);
            const Long t = -glm::dot(normal, ray.origin) / rate;
            const LongVector p = ray.origin + t * ray.direction;
            const Long rho = p.x * std::cos(angle) + p.y * std::sin(angle);
            if (rate != 0.0L && t >= ray.first && std::hypot(rho - bend_radius_, p.z) <= radius_) {
                nearest = std::min(nearest, t);
            }
        }
        return nearest;
    }

    Crossings wall_;
    Long bend_radius_;
    Long radius_;
    Long arc_;
    bool ring_;
};

// A hundredth of a pixel, 1024 of which span the torus.
Long tie_distance(const f32::Torus& torus) {
    return 0.01L * 2.0L * Long(torus.bend_radius + torus.radius) / 1024.0L;
}

LongRay exact(const f32::Ray& ray) {
    return {LongVector(ray.origin), LongVector(ray.direction), Long(ray.first)};
}

// How deep in the tube a place of the ray is; negative outside.
Long depth_at(const LongRay& ray, Long t, const f32::Torus& torus) {
    const LongVector p = ray.origin + t * ray.direction;
    return Long(torus.radius) - std::hypot(std::hypot(p.x, p.y) - Long(torus.bend_radius), p.z);
}

// Whether less than a hundredth of a pixel decides: the solver's place is that near to the wall,
// and nothing deeper than that was passed on the way to it.
bool is_graze(const LongRay& ray, Long true_t, Long solver_t, const f32::Torus& torus) {
    constexpr int samples = 64;
    const Long tie = tie_distance(torus);
    bool shallow = std::abs(depth_at(ray, solver_t, torus)) < tie;
    for (int i = 0; i <= samples && solver_t > true_t && shallow; ++i) {
        shallow = depth_at(ray, true_t + (solver_t - true_t) * Long(i) / samples, torus) < tie;
    }
    return shallow;
}

// Whether the truth of a ray less than a hundredth of a pixel aside is what the solver found. Also
// of rays much nearer: where a ray grazes, a little aside moves its hit far along.
bool is_tie(const Truth& truth, const LongRay& ray, const f32::Hit& hit, const f32::Torus& torus) {
    const Long aside = tie_distance(torus);
    const LongVector axis =
        std::abs(ray.direction.x) < 0.6L ? LongVector(1, 0, 0) : LongVector(0, 1, 0);
    const LongVector u = glm::normalize(glm::cross(ray.direction, axis));
    const LongVector v = glm::normalize(glm::cross(ray.direction, u));
    for (int i = 0; i < 8 * 16; ++i) {
        const Long angle = Long(i % 8) * std::numbers::pi_v<Long> / 4.0L;
        const Long distance = aside * std::pow(0.5L, Long(i / 8));
        LongRay beside = ray;
        beside.origin += distance * (std::cos(angle) * u + std::sin(angle) * v);
        const Long t = truth.first_hit(beside);
        const bool found = t < infinity;
        if (found == hit.found &&
            (!found || std::abs(t - Long(hit.t)) < 0.1L * Long(torus.radius))) {
            return true;
        }
    }
    return false;
}

void try_ray(Random& random, const RayTrialOptions& options, RayTrial& into) {
    const f32::Torus torus = random_torus(random, options);
    const double outer = static_cast<double>(torus.bend_radius + torus.radius);
    const f32::Ray ray = as_drawn(random_ray(random, torus, options.kind), outer);
    const f32::Hit hit = f32().hit(torus, ray, 0, options.solver);
    const Truth truth(torus);
    const LongRay same = exact(ray);
    const Long t = truth.first_hit(same);
    const bool found = t < infinity;
    ++into.rays;
    into.hits += found;
    into.steps += static_cast<std::uint64_t>(hit.steps);
    into.steps_max = std::max(into.steps_max, static_cast<std::uint64_t>(hit.steps));
    const Long error = std::abs(t - Long(hit.t)) * glm::length(same.direction) / Long(torus.radius);
    if (found == hit.found && (!found || error < 0.1L)) {
        if (found) {
            into.errors.add(static_cast<double>(error));
        }
        return;
    }
    if ((hit.found && is_graze(same, t, Long(hit.t), torus)) || is_tie(truth, same, hit, torus)) {
        ++into.ties;
    } else {
        ++(found == hit.found ? into.elsewhere_hard : found ? into.missed_hard : into.false_hard);
    }
}

}  // namespace

std::string_view name(RayKind kind) {
    constexpr std::array<std::string_view, ray_kind_count> names{"near", "far", "grazing",
                                                                 "in_tube", "in_bore"};
    return names[static_cast<std::size_t>(kind)];
}

void ErrorHistogram::add(double error) {
    const double octaves = std::log2(std::max(error, 1e-300)) - octave_min;
    const auto last = static_cast<double>(counts_.size() - 1);
    const double step = std::clamp(std::floor(octaves * steps_per_octave), 0.0, last);
    ++counts_[static_cast<std::size_t>(step)];
    ++count_;
    most_ = std::max(most_, error);
}

void ErrorHistogram::add(const ErrorHistogram& other) {
    for (std::size_t i = 0; i < counts_.size(); ++i) {
        counts_[i] += other.counts_[i];
    }
    count_ += other.count_;
    most_ = std::max(most_, other.most_);
}

double ErrorHistogram::quantile(double part) const {
    const double wanted = part * static_cast<double>(count_);
    std::uint64_t below = 0;
    for (std::size_t i = 0; i < counts_.size(); ++i) {
        below += counts_[i];
        if (below > 0 && static_cast<double>(below) >= wanted) {
            const double octaves = static_cast<double>(i + 1) / steps_per_octave + octave_min;
            return std::min(std::exp2(octaves), most_);
        }
    }
    return most_;
}

void RayTrial::add(const RayTrial& other) {
    rays += other.rays;
    hits += other.hits;
    missed_hard += other.missed_hard;
    false_hard += other.false_hard;
    elsewhere_hard += other.elsewhere_hard;
    ties += other.ties;
    steps += other.steps;
    steps_max = std::max(steps_max, other.steps_max);
    errors.add(other.errors);
}

RayTrial try_rays(const RayTrialOptions& options) {
    constexpr std::uint64_t rows_at_once = 1024;
    RayTrial all;
    const std::uint64_t row_count = (options.rays + rays_per_row - 1) / rays_per_row;
    for (std::uint64_t first = 0; first < row_count && !options.is_stopped();
         first += rows_at_once) {
        const auto rows = static_cast<int>(std::min(rows_at_once, row_count - first));
        std::vector<RayTrial> trials(static_cast<std::size_t>(rows));
        for_each_row(
            rows,
            [&](int row) {
                const std::uint64_t number = first + static_cast<std::uint64_t>(row);
                Random random(static_cast<std::uint64_t>(options.kind) + 1, number);
                const std::uint64_t count =
                    std::min(rays_per_row, options.rays - number * rays_per_row);
                for (std::uint64_t i = 0; i < count; ++i) {
                    try_ray(random, options, trials[static_cast<std::size_t>(row)]);
                }
            },
            options.is_stopped);
        for (const RayTrial& trial : trials) {
            all.add(trial);
        }
    }
    return all;
}

}  // namespace quartic
