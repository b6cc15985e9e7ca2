// Random rays at random tori and elbows, each answered by a solver in float and by the truth in
// long double: what no picture shows in such numbers.
#pragma once

#include "bench/truth.h"

#include <array>
#include <cstdint>
#include <functional>
#include <string_view>

namespace quartic {

// How a ray is chosen.
enum class RayKind {
    near,     // from a few radii away at anything in the sphere around the torus
    far,      // the same from up to 100,000 radii away
    grazing,  // along a tangent, beside it by a billionth to a tenth of the tube
    in_tube,  // from inside the tube
    in_bore,  // from inside the hole
};
constexpr std::size_t ray_kind_count = 5;
std::string_view name(RayKind kind);

// A histogram of errors in equal steps of their logarithm, ten to a factor of two.
class ErrorHistogram {
public:
    void add(double error);
    void add(const ErrorHistogram& other);
    // The error that this part of all stays below, to a step.
    double quantile(double part) const;
    double most() const { return most_; }
    std::uint64_t count() const { return count_; }

private:
    static constexpr int steps_per_octave = 10;
    static constexpr int octave_min = -60;
    std::array<std::uint64_t, 80 * steps_per_octave> counts_{};
    std::uint64_t count_ = 0;
    double most_ = 0.0;
};

// A wrong answer is a tie where the truth of a ray a hundredth of a pixel beside agrees with it: of
// pixels 1024 of which span the torus.
struct RayTrial {
    std::uint64_t rays = 0;
    std::uint64_t hits = 0;  // true ones
    std::uint64_t missed_hard = 0;
    std::uint64_t false_hard = 0;
    std::uint64_t elsewhere_hard = 0;  // off by more than a tenth of the tube's radius
    std::uint64_t ties = 0;
    std::uint64_t steps = 0;
    std::uint64_t steps_max = 0;
    ErrorHistogram errors;  // along the ray, of the tube's radius

    void add(const RayTrial& other);
};

// Of tori of r / R from 0.05 to 5 (spindles whole, others with arcs of 1 to 360 degrees), or, with
// a ratio, of that alone. The same rays for every call, however many threads.
struct RayTrialOptions {
    std::uint64_t rays = 1'000'000;
    RayKind kind = RayKind::near;
    double ratio = 0.0;  // r / R; 0: random
    bool arcs = false;   // elbows with caps instead of rings
    int solver = 1;
    std::function<bool()> is_stopped = [] { return false; };
};

RayTrial try_rays(const RayTrialOptions& options);

}  // namespace quartic
