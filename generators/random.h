// Random numbers that are the same on every machine, which those of the standard library's
// distributions are not.
#pragma once

#include <glm/glm.hpp>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <span>

namespace quartic {

// SplitMix64 (Steele, Lea and Flood 2014, figure 16).
class Random {
public:
    explicit Random(std::uint64_t seed) : state_(seed) {}
    // An independent sequence for each number: a unit of a plant does not depend on its neighbours.
    Random(std::uint64_t seed, std::uint64_t number) : state_(seed) {
        state_ = next() ^ (number * step);
    }

    std::uint64_t next() {
        state_ += step;
        std::uint64_t z = state_;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return z ^ (z >> 31);
    }
    double between(double low, double high) {
        return low + (high - low) * (static_cast<double>(next() >> 11) * 0x1p-53);
    }
    int whole(int low, int high) {  // both included
        return low + static_cast<int>(next() % static_cast<std::uint64_t>(high - low + 1));
    }
    bool chance(double probability) { return between(0.0, 1.0) < probability; }

    template <class Value, std::size_t count>
    const Value& pick(const Value (&values)[count]) {
        return values[next() % count];
    }

private:
    static constexpr std::uint64_t step = 0x9e3779b97f4a7c15u;
    std::uint64_t state_;
};

// A unit vector, all directions alike.
inline glm::dvec3 random_direction(Random& random) {
    const double z = random.between(-1.0, 1.0);
    const double angle = random.between(0.0, 2.0 * std::numbers::pi);
    const double rho = std::sqrt(1.0 - z * z);
    return {rho * std::cos(angle), rho * std::sin(angle), z};
}

}  // namespace quartic
