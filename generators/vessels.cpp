// Vessels: shells, dished ends, what they stand on, and their nozzles.
#include "generators/equipment.h"
#include "generators/steel.h"

#include <cmath>
#include <numbers>

namespace quartic {
namespace {

using glm::dvec3;

constexpr double pi = std::numbers::pi;
constexpr dvec3 up{0.0, 0.0, 1.0};

// A stub with a flange; the pipe begins at the flange's face.
Nozzle add_nozzle(Model& model, const dvec3& surface, const dvec3& out, double radius) {
    model.begin("NOZZLE", surface);
    const double length = 0.25 + radius;
    const double thickness = 0.012 + 0.16 * radius;
    const dvec3 face = surface + length * out;
    model.cylinder(surface - 0.1 * out, face - thickness * out, radius);
    model.cylinder(face - thickness * out, face, 1.45 * radius + 0.045);
    model.end();
    return {face, out, radius};
}

void add_manway(Model& model, const dvec3& surface, const dvec3& out) {
    model.begin("MANWAY", surface);
    model.cylinder(surface - 0.1 * out, surface + 0.3 * out, 0.3);
    model.cylinder(surface + 0.3 * out, surface + 0.42 * out, 0.42);
    model.disc({surface + 0.43 * out, 0.3}, out);
    const dvec3 across = axes_along(out)[0];
    model.torus({surface + 0.43 * out, across, out, pi}, 0.12, 0.012);
    model.end();
}

void add_saddle(Model& model, const dvec3& axis_point, double radius) {
    model.use(Finish::concrete);
    model.box({axis_point.x, axis_point.y, 0.25}, {0.6, 1.9 * radius, 0.5});
    model.use(Finish::steel);
    const double height = axis_point.z - 0.6 * radius - 0.5;
    model.pyramid({0.3, 1.75 * radius, 0.3, 1.95 * radius, 0.0, 0.0, height + 0.3 * radius, 0.0},
                  {axis_point.x, axis_point.y, 0.5 + 0.5 * (height + 0.3 * radius)});
    model.use(Finish::vessel);
}

void add_skirt(Model& model, const dvec3& foot, double radius, double height) {
    model.use(Finish::concrete);
    model.cylinder(foot, foot + 0.4 * up, radius + 0.5);
    model.use(Finish::steel);
    model.cylinder(foot + 0.4 * up, foot + 0.5 * up, radius + 0.2);
    model.cone({foot + 0.5 * up, radius + 0.1}, {foot + height * up, radius});
}

}  // namespace

std::vector<Nozzle> add_column_vessel(Model& model, Random& random, const dvec3& foot,
                                      double side) {
    const double radius = random.between(0.9, 1.6);
    const double base = random.between(2.5, 3.5);
    const double height = random.between(13.0, 24.0);
    const dvec3 low = foot + base * up;
    const dvec3 high = foot + (base + height) * up;
    add_skirt(model, foot, radius, base);
    model.use(Finish::vessel);
    model.dish({low, radius}, -up, 0.5 * radius);
    const bool stepped = random.chance(0.4);
    const dvec3 waist = low + (0.55 * height) * up;
    const double top_radius = stepped ? 0.72 * radius : radius;
    model.cylinder(low, waist, radius);
    model.cone({waist, radius}, {waist + 0.9 * up, top_radius});
    model.cylinder(waist + 0.9 * up, high, top_radius);
    model.dish({high, top_radius}, up, 0.5 * top_radius, random.chance(0.3));
    for (double z = 2.5; z < height - 1.0; z += 3.0) {  // stiffening rings
        const double r = z < 0.55 * height ? radius : (z < 0.55 * height + 0.9 ? 0.0 : top_radius);
        if (r > 0.0) {
            model.torus({low + z * up, up, {1.0, 0.0, 0.0}, 2.0 * pi}, r, 0.035);
        }
    }
    std::vector<Nozzle> nozzles;
    const dvec3 towards(0.0, side, 0.0);
    const double places[] = {0.1, 0.35, 0.85};
    for (const double place : places) {
        const double r = place < 0.55 ? radius : top_radius;
        nozzles.push_back(add_nozzle(model, low + (place * height) * up + r * towards, towards,
                                     random.between(0.08, 0.2)));
    }
    nozzles.push_back(
        add_nozzle(model, high + (0.5 * top_radius - 0.05) * up, up, 0.22 * top_radius));
    add_manway(model, low + (0.2 * height) * up - radius * towards, -towards);
    double below = foot.z;
    for (const double place : {0.22, 0.5, 0.92}) {
        const double level = foot.z + base + place * height;
        const double r = place < 0.55 ? radius : top_radius;
        const double start = (side > 0.0 ? pi : 0.0) + 0.15;
        add_ring_platform(model, {{foot.x, foot.y, level}, r, start, random.between(1.9, 2.8)});
        const dvec3 out(std::cos(start + 0.12), std::sin(start + 0.12), 0.0);
        const double reach = radius + 1.3;
        add_ladder(
            model,
            {{foot.x + reach * out.x, foot.y + reach * out.y, below}, level - below, out, true});
        below = level;
    }
    return nozzles;
}

std::vector<Nozzle> add_drum(Model& model, Random& random, const dvec3& foot, double side) {
    const double radius = random.between(0.9, 1.5);
    const double half = random.between(2.6, 4.2);
    const dvec3 centre = foot + dvec3(0.0, 0.0, radius + random.between(1.2, 2.6));
    const dvec3 along(1.0, 0.0, 0.0);
    const dvec3 a = centre - half * along;
    const dvec3 b = centre + half * along;
    model.use(Finish::vessel);
    model.cylinder(a, b, radius);
    model.dish({a, radius}, -along, 0.5 * radius);
    model.dish({b, radius}, along, 0.5 * radius);
    add_saddle(model, centre - (0.65 * half) * along, radius);
    add_saddle(model, centre + (0.65 * half) * along, radius);
    add_manway(model, b + 0.45 * radius * along, along);
    std::vector<Nozzle> nozzles;
    for (const double place : {-0.7, 0.1}) {
        nozzles.push_back(add_nozzle(model, centre + (place * half) * along + radius * up, up,
                                     random.between(0.08, 0.18)));
    }
    const dvec3 towards(0.0, side, 0.0);
    nozzles.push_back(add_nozzle(model, centre + (0.45 * half) * along + radius * towards, towards,
                                 random.between(0.06, 0.12)));
    add_platform(model, centre + dvec3(0.0, -side * (radius + 1.3), 0.2), {2.2 * half, 1.4});
    return nozzles;
}

std::vector<Nozzle> add_legged_drum(Model& model, Random& random, const dvec3& foot, double side) {
    const double radius = random.between(0.7, 1.3);
    const double height = random.between(2.5, 4.5);
    const dvec3 low = foot + random.between(1.8, 2.6) * up;
    const dvec3 high = low + height * up;
    model.use(Finish::concrete);
    model.box(foot + 0.15 * up, {2.6 * radius, 2.6 * radius, 0.3});
    model.use(Finish::steel);
    for (int i = 0; i < 4; ++i) {
        const double angle = 0.5 * pi * (i + 0.5);
        const dvec3 out(std::cos(angle), std::sin(angle), 0.0);
        const dvec3 place = foot + (radius + 0.06) * out;
        model.bar(place + 0.3 * up, place + (low.z - foot.z + 0.7) * up, 0.14, 0.14);
    }
    model.use(Finish::vessel);
    model.cylinder(low, high, radius);
    model.dish({low, radius}, -up, 0.45 * radius);
    model.dish({high, radius}, up, 0.45 * radius, random.chance(0.5));
    const dvec3 towards(0.0, side, 0.0);
    std::vector<Nozzle> nozzles;
    nozzles.push_back(add_nozzle(model, high + 0.44 * radius * up, up, random.between(0.06, 0.14)));
    nozzles.push_back(
        add_nozzle(model, low + 0.5 * up + radius * towards, towards, random.between(0.05, 0.1)));
    add_manway(model, low + (0.6 * height) * up - radius * towards, -towards);
    add_ladder(model,
               {foot + dvec3(radius + 0.25, 0.0, 0.0), high.z - foot.z, {1.0, 0.0, 0.0}, false});
    return nozzles;
}

std::vector<Nozzle> add_exchangers(Model& model, Random& random, const dvec3& foot, double side) {
    const double radius = random.between(0.45, 0.7);
    const double half = random.between(2.2, 3.0);
    const dvec3 along(0.0, side, 0.0);
    std::vector<Nozzle> nozzles;
    const dvec3 axis = foot + dvec3(0.0, 0.0, 1.2 + radius);
    for (const double place : {-0.55, 0.55}) {
        const dvec3 middle = foot + (place * half) * along;
        model.use(Finish::concrete);
        model.box(middle + 0.4 * up, {2.2 * radius, 0.5, 0.8});
        model.use(Finish::steel);
        const double top = 1.2 + 2.0 * radius + 0.9 + 0.5 * radius;  // inside the upper shell
        model.box(middle + 0.5 * (0.8 + top) * up, {1.5 * radius, 0.22, top - 0.8});
    }
    for (int i = 0; i < 2; ++i) {
        const dvec3 centre = axis + (i * (2.0 * radius + 0.9)) * up;
        model.begin("SHELL " + std::to_string(i + 1), centre);
        model.use(Finish::vessel);
        const dvec3 head = centre + half * along;
        const dvec3 rear = centre - half * along;
        model.cylinder(rear, head, radius);
        model.dish({rear, radius}, -along, 0.5 * radius);
        for (int plate = 0; plate < 2; ++plate) {
            model.cylinder(head + (0.13 * plate) * along, head + (0.13 * plate + 0.12) * along,
                           radius + 0.13);
        }
        model.cylinder(head + 0.25 * along, head + 1.15 * along, radius);
        model.cylinder(head + 1.15 * along, head + 1.27 * along, radius + 0.13);
        nozzles.push_back(add_nozzle(model, head + 0.7 * along + radius * up, up, 0.3 * radius));
        if (i == 1) {
            nozzles.push_back(
                add_nozzle(model, rear + 0.6 * along + radius * up, up, 0.35 * radius));
        } else {
            nozzles.pop_back();  // the upper shell stands over it
            add_nozzle(model, rear + 0.6 * along + radius * up, up, 0.2 * radius);
        }
        model.end();
    }
    return nozzles;
}

std::vector<Nozzle> add_tank(Model& model, Random& random, const dvec3& foot, double side) {
    const double radius = random.between(3.0, 4.3);
    const double height = random.between(5.0, 8.5);
    model.use(Finish::concrete);
    model.cylinder(foot, foot + 0.3 * up, radius + 0.4);
    model.use(Finish::vessel);
    const dvec3 low = foot + 0.3 * up;
    const dvec3 high = low + height * up;
    model.cylinder(low, high, radius);
    const bool domed = random.chance(0.5);
    if (domed) {
        model.dish({high, radius}, up, 0.2 * radius, true);
    } else {
        model.cone({high, radius}, {high + 0.16 * radius * up, 0.0});
    }
    model.torus({high, up, {1.0, 0.0, 0.0}, 2.0 * pi}, radius, 0.07);
    const dvec3 towards(0.0, side, 0.0);
    std::vector<Nozzle> nozzles;
    nozzles.push_back(
        add_nozzle(model, low + 0.7 * up + radius * towards, towards, random.between(0.1, 0.2)));
    const dvec3 aside = glm::normalize(dvec3(0.5, side, 0.0));
    add_manway(model, low + 0.8 * up + radius * aside, aside);
    model.use(Finish::rail);
    model.begin("HANDRAIL", high);
    for (const double level : {0.55, 1.1}) {
        model.torus({high + level * up, up, {1.0, 0.0, 0.0}, 2.0 * pi}, radius - 0.05,
                    radius / 190.0);
    }
    for (int i = 0; i < 24; ++i) {
        const dvec3 post =
            high + (radius - 0.05) * dvec3(std::cos(pi * i / 12.0), std::sin(pi * i / 12.0), 0.0);
        model.cylinder(post, post + 1.1 * up, 0.02);
    }
    model.end();
    add_ladder(model, {foot + dvec3(radius + 0.45, 0.0, 0.0), height + 0.3, {1.0, 0.0, 0.0}, true});
    return nozzles;
}

}  // namespace quartic
