// Clouds of tori and of elbows, for benchmarks of solvers.
#include "generators/kinds.h"
#include "generators/random.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace quartic {
namespace {

constexpr double pi = std::numbers::pi;
constexpr Finish colours[] = {Finish::process, Finish::steam,  Finish::water,   Finish::gas,
                              Finish::air,     Finish::vessel, Finish::chemical};

// Places of a jittered grid in a cube, so that few overlap.
class Places {
public:
    Places(const GenerateOptions& options)
        : side_(std::max(1.0, std::ceil(std::cbrt(double(options.count))))),
          pitch_(options.extent_m > 0.0 ? options.extent_m / side_ : 1.0) {}

    double pitch() const { return pitch_; }
    glm::dvec3 at(std::uint64_t index, Random& random) const {
        const auto side = static_cast<std::uint64_t>(side_);
        const glm::dvec3 cell(double(index % side), double(index / side % side),
                              double(index / side / side));
        const glm::dvec3 jitter(random.between(0.35, 0.65), random.between(0.35, 0.65),
                                random.between(0.35, 0.65));
        return pitch_ * (cell + jitter);
    }

private:
    double side_;
    double pitch_;
};

}  // namespace

Scene make_tori(const GenerateOptions& options) {
    Model model(options.count);
    const Places places(options);
    model.begin("TORI", glm::dvec3(0.0));
    for (std::uint64_t i = 0; i < options.count; ++i) {
        Random random(options.seed, i);
        const double outer = places.pitch() * random.between(0.3, 0.48);
        const double ratio = random.between(1.05, 8.0);
        const double radius = outer / (1.0 + ratio);
        const glm::dvec3 axis = random_direction(random);
        model.use(random.pick(colours));
        const glm::dvec3 centre = places.at(i, random);
        model.begin("TORUS " + std::to_string(i + 1), centre);
        model.torus({centre, axis, axes_along(axis)[0], 2.0 * pi}, ratio * radius, radius);
        model.end();
    }
    model.end();
    return model.take();
}

Scene make_elbows(const GenerateOptions& options) {
    constexpr double arcs_deg[] = {90.0, 90.0, 90.0, 90.0, 45.0, 45.0, 60.0, 30.0, 15.0, 180.0};
    constexpr double ratios[] = {2.0, 2.28, 2.52, 2.66, 2.72, 3.0, 5.0, 11.5};
    Model model(options.count);
    const Places places(options);
    model.begin("ELBOWS", glm::dvec3(0.0));
    for (std::uint64_t i = 0; i < options.count; ++i) {
        Random random(options.seed, i);
        const double outer = places.pitch() * random.between(0.3, 0.5);
        const double ratio = random.pick(ratios);
        const glm::dvec3 axis = random_direction(random);
        const glm::dvec3 from = axes_along(axis)[0];
        const double radius = outer / (1.0 + ratio);
        model.use(random.pick(colours));
        const glm::dvec3 centre = places.at(i, random);
        model.begin("ELBOW " + std::to_string(i + 1), centre);
        model.torus({centre, axis, from, random.pick(arcs_deg) * pi / 180.0}, ratio * radius,
                    radius);
        model.end();
    }
    model.end();
    return model.take();
}

// Cylinder, elbow, cylinder, reducer, cap: what every joint must look right in.
Scene make_run(const GenerateOptions&) {
    Model model(100);
    model.use(Finish::process);
    model.begin("PIPE-200-P-1", glm::dvec3(0.0));
    model.begin("B1");
    const double radius = 0.1095;
    const double bend = 2.66 * radius;
    const glm::dvec3 x(1.0, 0.0, 0.0);
    const glm::dvec3 z(0.0, 0.0, 1.0);
    model.begin("TUBE 1");
    model.cylinder(glm::dvec3(0.0), x, radius);
    model.end();
    model.begin("ELBOW 1", x);
    model.torus({x + bend * z, glm::cross(x, z), -z, 0.5 * pi}, bend, radius);
    model.end();
    const glm::dvec3 foot = x + bend * (x + z);
    model.begin("TUBE 2", foot);
    model.cylinder(foot, foot + 0.8 * z, radius);
    model.end();
    model.begin("REDUCER 1", foot + 0.8 * z);
    model.cone({foot + 0.8 * z, radius}, {foot + 1.1 * z, 0.0842});
    model.end();
    model.begin("CAP 1", foot + 1.1 * z);
    model.dish({foot + 1.1 * z, 0.0842}, z, 0.0421);
    model.end();
    model.end();
    model.end();
    return model.take();
}

}  // namespace quartic
