// Sizes are multiples of the pipe's radius, near those of ASME B16.5 flanges and B16.10 valves.
#include "generators/fittings.h"

#include <cmath>
#include <numbers>

namespace quartic {
namespace {

constexpr double pi = std::numbers::pi;

double plate(double radius) {
    return 0.012 + 0.16 * radius;
}

double neck(double radius) {
    return 0.02 + 0.4 * radius;
}

double flange_radius(double radius) {
    return 1.45 * radius + 0.045;
}

void add_bolts(Model& model, const Station& middle, double reach) {
    const int count = middle.radius < 0.08 ? 4 : (middle.radius < 0.16 ? 8 : 12);
    const double circle = 0.5 * (flange_radius(middle.radius) + 1.15 * middle.radius);
    const glm::dmat3 axes = axes_along(middle.along);
    for (int i = 0; i < count; ++i) {
        const double angle = 2.0 * pi * (i + 0.5) / count;
        const glm::dvec3 place =
            middle.position + circle * (std::cos(angle) * axes[0] + std::sin(angle) * axes[1]);
        model.cylinder(place - reach * middle.along, place + reach * middle.along,
                       0.006 + 0.03 * middle.radius);
    }
}

// Two halves, as plants draw hand-wheels, and three spokes.
void add_hand_wheel(Model& model, const glm::dvec3& centre, const glm::dvec3& axis,
                    double wheel_radius) {
    const Finish before = model.finish();
    model.begin("HANDWHEEL", centre);
    model.use(Finish::wheel);
    const glm::dmat3 axes = axes_along(axis);
    const double tube = wheel_radius / 11.5;
    model.torus({centre, axis, axes[0], pi}, wheel_radius, tube);
    model.torus({centre, axis, -axes[0], pi}, wheel_radius, tube);
    for (int i = 0; i < 3; ++i) {
        const double angle = 2.0 * pi * i / 3.0;
        const glm::dvec3 out = std::cos(angle) * axes[0] + std::sin(angle) * axes[1];
        model.cylinder(centre, centre + wheel_radius * out, 0.6 * tube);
    }
    model.sphere({centre, 1.8 * tube});
    model.end();
    model.use(before);
}

}  // namespace

double flange_pair_length(double radius) {
    return 2.0 * (plate(radius) + neck(radius)) + 0.003;
}

double valve_length(double radius) {
    return 2.0 * flange_pair_length(radius) + 3.2 * radius + 0.06;
}

void add_flange_pair(Model& model, const Station& station, int number, bool bolted) {
    const double r = station.radius;
    const glm::dvec3 n = station.along;
    const double outer = flange_radius(r);
    model.begin("FLANGE " + std::to_string(number), station.position);
    glm::dvec3 at = station.position;
    const auto advance = [&](double length) { return at + length * n; };
    model.cone({at, r}, {advance(neck(r)), 1.22 * r});
    at = advance(neck(r));
    model.cylinder(at, advance(plate(r)), outer);
    at = advance(plate(r));
    model.cylinder(at, advance(0.003), 1.2 * r);
    const glm::dvec3 middle = advance(0.0015);
    at = advance(0.003);
    model.cylinder(at, advance(plate(r)), outer);
    at = advance(plate(r));
    model.cone({at, 1.22 * r}, {advance(neck(r)), r});
    if (bolted) {
        add_bolts(model, {middle, n, r}, plate(r) + 0.012 + 0.02 * r);
    }
    model.end();
}

void add_valve(Model& model, const Station& station, int number, const glm::dvec3& up) {
    const double r = station.radius;
    const glm::dvec3 n = station.along;
    const double flange = flange_pair_length(r);
    const double half = 0.5 * (valve_length(r) - 2.0 * flange);
    const glm::dvec3 centre = station.position + (flange + half) * n;
    model.begin("VALVE " + std::to_string(number), centre);
    add_flange_pair(model, station, 1, r > 0.1);
    model.cone({centre - half * n, r}, {centre, 0.45 * r});
    model.cone({centre, 0.45 * r}, {centre + half * n, r});
    model.sphere({centre, 0.8 * r});
    const glm::dvec3 bonnet = centre + (1.7 * r) * up;
    const glm::dvec3 top = centre + (3.6 * r + 0.12) * up;
    model.cylinder(centre, bonnet, 0.55 * r);
    model.cylinder(bonnet, bonnet + (0.1 * r + 0.015) * up, 0.95 * r);
    model.cylinder(bonnet, top, 0.16 * r + 0.004);
    add_hand_wheel(model, top, up, 1.5 * r + 0.06);
    add_flange_pair(model, {centre + half * n, n, r}, 2, false);
    model.end();
}

void add_cap(Model& model, const Station& station) {
    model.begin("CAP 1", station.position);
    model.dish({station.position, station.radius}, station.along, 0.5 * station.radius);
    model.end();
}

void add_blind(Model& model, const Station& station) {
    const double r = station.radius;
    model.begin("FBLIND 1", station.position);
    const glm::dvec3 face = station.position + neck(r) * station.along;
    model.cone({station.position, r}, {face, 1.22 * r});
    model.cylinder(face, face + (2.0 * plate(r)) * station.along, flange_radius(r));
    model.disc({face + (2.0 * plate(r) + 0.002) * station.along, 1.2 * r}, station.along);
    model.end();
}

}  // namespace quartic
