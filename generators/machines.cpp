// Pumps, and a house with ducts.
#include "generators/equipment.h"
#include "generators/steel.h"

#include <cmath>
#include <numbers>

namespace quartic {
namespace {

using glm::dvec3;

constexpr double pi = std::numbers::pi;
constexpr dvec3 up{0.0, 0.0, 1.0};

// Motor, coupling and casing along y; suction at its end through an eccentric reducer, discharge
// upwards.
void add_pump(Model& model, const dvec3& foot, double side, double size,
              std::vector<Nozzle>& nozzles) {
    const dvec3 along(0.0, side, 0.0);
    const dvec3 axis = foot + (0.45 + 0.5 * size) * up;
    model.use(Finish::concrete);
    model.box(foot + 0.15 * up, {1.1 * size, 3.6 * size, 0.3});
    model.use(Finish::machine);
    model.box(foot + 0.36 * up, {0.8 * size, 3.1 * size, 0.12});
    model.cylinder(axis - 1.5 * size * along, axis - 0.35 * size * along, 0.32 * size);
    for (int i = 0; i < 6; ++i) {  // cooling fins
        const dvec3 place = axis - (1.4 - 0.16 * i) * size * along;
        model.cylinder(place, place + 0.03 * size * along, 0.37 * size);
    }
    model.box(axis - 0.9 * size * along + 0.4 * size * up, {0.3 * size, 0.3 * size, 0.22 * size});
    model.use(Finish::rail);
    model.cylinder(axis - 0.35 * size * along, axis + 0.1 * size * along, 0.16 * size);
    model.use(Finish::machine);
    model.cone({axis + 0.1 * size * along, 0.2 * size}, {axis + 0.4 * size * along, 0.36 * size});
    model.cylinder(axis + 0.4 * size * along, axis + 0.75 * size * along, 0.42 * size);
    const double suction = 0.16 * size;
    const dvec3 mouth = axis + 1.0 * size * along;
    model.cylinder(axis + 0.75 * size * along, mouth, suction);
    model.cylinder(mouth, mouth + 0.06 * size * along, 1.7 * suction);
    const dvec3 face = mouth + 0.06 * size * along;
    const double wide = 1.5 * suction;
    const dvec3 drop(0.0, 0.0, suction - wide);  // flat on top: no gas stays there
    model.begin("REDUCER 1", face);
    model.use(Finish::process);
    model.reducer({face, suction}, {face + 0.5 * size * along + drop, wide}, along);
    model.end();
    nozzles.push_back({face + 0.5 * size * along + drop, along, wide});
    model.use(Finish::machine);
    const dvec3 outlet = axis + 0.57 * size * along;
    model.cylinder(outlet, outlet + 0.62 * size * up, 0.12 * size);
    model.cylinder(outlet + 0.62 * size * up, outlet + 0.68 * size * up, 0.24 * size);
    nozzles.push_back({outlet + 0.68 * size * up, up, 0.12 * size});
}

// A rectangular duct from the wall: straight, bend, straight, and a hood.
void add_square_duct(Model& model, const dvec3& start, double side) {
    model.begin("DUCT 1", start);
    model.use(Finish::duct);
    const double width = 0.8;
    const double height = 0.6;
    const double inner = 0.4;
    const double middle = inner + 0.5 * width;
    const dvec3 along(1.0, 0.0, 0.0);
    const dvec3 inwards(0.0, side, 0.0);
    const dvec3 corner = start + 2.0 * along;
    model.box(0.5 * (start + corner), {2.0, width, height});
    const dvec3 axis = glm::cross(along, inwards);
    model.duct_turn({corner + middle * inwards, axis, -inwards, 0.5 * pi}, {inner, inner + width},
                    height);
    const dvec3 next = corner + middle * along + middle * inwards;
    model.box(next + 0.6 * inwards, {width, 1.2, height});
    model.pyramid({1.5 * width, 1.5 * width, width, height, 0.0, 0.0, 0.5, 0.0},
                  next + 0.6 * inwards + 0.55 * up);
    model.end();
}

// A round duct whose bends are mitred pieces.
void add_round_duct(Model& model, const dvec3& start, double side) {
    model.begin("DUCT 2", start);
    model.use(Finish::duct);
    const double radius = 0.35;
    const int pieces = 4;
    const double bend = 0.9;
    const double step = 0.5 * pi / pieces;
    // Corners on the tangents of the bend's circle, so that every cut halves an angle.
    const double reach = bend / std::cos(0.5 * step);
    const dvec3 centre = start + 1.5 * up + dvec3(0.0, side * bend, 0.0);
    dvec3 from = start;
    dvec3 from_normal = up;
    for (int i = 0; i <= pieces; ++i) {
        const double angle = step * (i + 0.5);
        const double cut = step * (i + 0.5);
        dvec3 to = centre + reach * dvec3(0.0, -side * std::cos(angle), std::sin(angle));
        dvec3 to_normal(0.0, side * std::sin(cut), std::cos(cut));
        if (i == pieces) {
            to = centre + bend * up + dvec3(0.0, side * 1.5, 0.0);
            to_normal = {0.0, side, 0.0};
        }
        model.mitred({from, radius}, to, from_normal, to_normal);
        from = to;
        from_normal = to_normal;
    }
    model.end();
}

}  // namespace

std::vector<Nozzle> add_pumps(Model& model, Random& random, const dvec3& foot, double side) {
    std::vector<Nozzle> nozzles;
    const int count = random.whole(2, 3);
    const double size = random.between(0.75, 1.1);
    for (int i = 0; i < count; ++i) {
        const dvec3 place = foot + dvec3(2.8 * (i - 0.5 * (count - 1)), 0.0, 0.0);
        model.begin("P-" + std::to_string(101 + i), place);
        add_pump(model, place, side, size, nozzles);
        model.end();
    }
    return nozzles;
}

std::vector<Nozzle> add_coil(Model& model, Random& random, const dvec3& foot, double side) {
    const int rows = 2 * random.whole(6, 9);
    const double radius = random.between(0.05, 0.08);
    const double pitch = 0.3;
    const double half = 3.2;
    model.use(Finish::steel);
    const double top = 1.0 + pitch * rows + 0.4;
    for (const double x : {-half - 0.4, half + 0.4}) {
        for (const double y : {-0.7, 0.7}) {
            model.bar(foot + dvec3(x, y, 0.0), foot + dvec3(x, y, top), 0.2, 0.2);
        }
        model.bar(foot + dvec3(x, -0.7, top), foot + dvec3(x, 0.7, top), 0.2, 0.2);
    }
    std::vector<Nozzle> nozzles;
    for (const double y : {-0.35, 0.35}) {
        model.begin(y < 0.0 ? "COIL 1" : "COIL 2", foot + dvec3(0.0, y, 1.0));
        model.use(Finish::steam);
        for (int i = 0; i < rows; ++i) {
            const double z = 1.0 + pitch * i;
            const dvec3 from = foot + dvec3(-half, y, z);
            const dvec3 to = foot + dvec3(half, y, z);
            model.cylinder(from, to, radius);
            if (i + 1 < rows) {  // left and right in turn, half around
                const double out = i % 2 == 0 ? 1.0 : -1.0;
                const dvec3 centre = foot + dvec3(out * half, y, z + 0.5 * pitch);
                model.torus({centre, {0.0, -out, 0.0}, {0.0, 0.0, -1.0}, pi}, 0.5 * pitch, radius);
            }
        }
        const dvec3 inlet = foot + dvec3(-half, y, 1.0);
        model.cylinder(inlet, inlet - dvec3(0.5, 0.0, 0.0), radius);
        const dvec3 outlet = foot + dvec3(-half, y, 1.0 + pitch * (rows - 1));
        model.cylinder(outlet, outlet - dvec3(0.5, 0.0, 0.0), radius);
        model.torus(
            {outlet + dvec3(-0.5, 0.0, 3.0 * radius), {0.0, 1.0, 0.0}, {0.0, 0.0, -1.0}, 0.5 * pi},
            3.0 * radius, radius);
        nozzles.push_back({outlet + dvec3(-0.5 - 3.0 * radius, 0.0, 3.0 * radius), up, radius});
        model.end();
    }
    add_platform(model, foot + dvec3(0.0, -side * 2.2, top - 1.5), {6.0, 1.6});
    return nozzles;
}

std::vector<Nozzle> add_house(Model& model, Random& random, const dvec3& foot, double side) {
    const glm::dvec3 size(8.5, 6.0, random.between(3.6, 4.6));
    model.use(Finish::concrete);
    model.box(foot + 0.5 * size.z * up, size);
    model.use(Finish::steel);
    model.box(foot + (size.z + 0.1) * up, {size.x + 0.4, size.y + 0.4, 0.2});
    model.use(Finish::tray);
    model.box(foot + dvec3(-2.0, side * (0.5 * size.y + 0.03), 1.1), {1.4, 0.06, 2.2});
    for (int i = 0; i < 3; ++i) {
        model.box(foot + dvec3(0.2 + 1.5 * i, side * (0.5 * size.y + 0.03), 2.2), {1.0, 0.06, 0.8});
    }
    const double roof = foot.z + size.z + 0.2;
    add_square_duct(model, {foot.x - 2.5, foot.y - side * 1.5, roof + 0.5}, side);
    add_round_duct(model, {foot.x + 3.2, foot.y - side * 1.6, roof}, side);
    model.use(Finish::machine);
    model.box({foot.x - 3.0, foot.y + side * 1.5, roof + 0.5}, {1.6, 1.6, 1.0});
    model.cylinder({foot.x - 3.0, foot.y + side * 1.5, roof + 1.0},
                   {foot.x - 3.0, foot.y + side * 1.5, roof + 1.2}, 0.6);
    return {};
}

}  // namespace quartic
