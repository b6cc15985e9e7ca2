// Members are bars; rails are thin tubes, bent ones tori.
#include "generators/steel.h"

#include <cmath>
#include <numbers>

namespace quartic {
namespace {

using glm::dvec3;

constexpr double rail_radius = 0.021;
constexpr double rail_height = 1.1;
constexpr dvec3 up{0.0, 0.0, 1.0};

dvec3 at_angle(double angle) {
    return {std::cos(angle), std::sin(angle), 0.0};
}

void add_column(Model& model, const dvec3& foot, double top) {
    model.use(Finish::concrete);
    model.pyramid({0.8, 0.8, 0.5, 0.5, 0.0, 0.0, 0.3, 0.0}, foot + dvec3(0.0, 0.0, 0.15));
    model.use(Finish::steel);
    model.box({foot.x, foot.y, 0.5 * (foot.z + 0.3 + top)}, {0.28, 0.28, top - foot.z - 0.3});
}

void add_bent(Model& model, const Rack& rack, double x, int number) {
    model.begin("BENT " + std::to_string(number), {x, rack.start.y, rack.start.z});
    const double half = 0.5 * rack.width;
    for (const double side : {-half, half}) {
        add_column(model, {x, rack.start.y + side, rack.start.z},
                   rack.start.z + rack.levels.back() + 0.1);
    }
    model.use(Finish::steel);
    for (const double level : rack.levels) {
        model.box({x, rack.start.y, rack.start.z + level - 0.15}, {0.22, rack.width - 0.28, 0.3});
    }
    model.end();
}

// Beams along both sides, and a brace in the middle bay.
void add_bay(Model& model, const Rack& rack, double x, int number, bool braced) {
    model.begin("BAY " + std::to_string(number), {x, rack.start.y, rack.start.z});
    model.use(Finish::steel);
    const double clear = 0.14;
    for (const double side : {-0.5 * rack.width, 0.5 * rack.width}) {
        const double y = rack.start.y + side;
        for (const double level : rack.levels) {
            model.bar({x + clear, y, rack.start.z + level - 0.45},
                      {x + rack.bay - clear, y, rack.start.z + level - 0.45}, 0.16, 0.24);
        }
        if (braced) {
            const double top = rack.start.z + rack.levels.front() - 0.6;
            model.bar({x + clear, y, rack.start.z + 0.5}, {x + 0.5 * rack.bay, y, top}, 0.1, 0.1);
            model.bar({x + 0.5 * rack.bay, y, top}, {x + rack.bay - clear, y, rack.start.z + 0.5},
                      0.1, 0.1);
        }
    }
    model.end();
}

}  // namespace

void add_rack(Model& model, const Rack& rack) {
    model.begin("RACK-1", rack.start);
    const int bays = static_cast<int>(std::lround(rack.length / rack.bay));
    for (int i = 0; i < bays; ++i) {
        const double x = rack.start.x + rack.bay * i;
        add_bent(model, rack, x + 0.5 * rack.bay, i + 1);
        if (i + 1 < bays) {
            add_bay(model, rack, x + 0.5 * rack.bay, i + 1, i == bays / 2);
        }
    }
    model.end();
}

void add_ladder(Model& model, const Ladder& ladder) {
    const dvec3 across = glm::cross(up, ladder.out);
    const dvec3 foot = ladder.foot + 0.2 * ladder.out;
    model.begin("LADDER", ladder.foot);
    model.use(Finish::rail);
    for (const double side : {-0.22, 0.22}) {
        model.cylinder(foot + side * across, foot + side * across + (ladder.height + 1.0) * up,
                       0.024);
    }
    const int rungs = static_cast<int>(ladder.height / 0.3);
    for (int i = 1; i <= rungs; ++i) {
        const dvec3 place = foot + (0.3 * i) * up;
        model.cylinder(place - 0.22 * across, place + 0.22 * across, 0.011);
    }
    const int hoops = ladder.caged ? static_cast<int>((ladder.height - 2.2) / 0.9) : 0;
    for (int i = 0; i < hoops; ++i) {
        const dvec3 centre = foot + 0.12 * ladder.out + (2.3 + 0.9 * i) * up;
        const double turn = 0.35;
        model.torus({centre, up, glm::normalize(-across + turn * -ladder.out),
                     std::numbers::pi + 2.0 * std::atan(turn)},
                    0.38, 0.012);
    }
    for (int i = 0; hoops > 1 && i < 3; ++i) {
        const dvec3 place =
            foot + 0.12 * ladder.out +
            0.38 * (std::sin(0.9 * (i - 1)) * across + std::cos(0.9 * (i - 1)) * ladder.out);
        model.cylinder(place + 2.3 * up, place + (2.3 + 0.9 * (hoops - 1)) * up, 0.01);
    }
    model.end();
}

void add_handrail(Model& model, const dvec3& from, const dvec3& to) {
    model.begin("HANDRAIL", from);
    model.use(Finish::rail);
    const double length = glm::length(to - from);
    const int posts = std::max(1, static_cast<int>(std::ceil(length / 1.5)));
    for (int i = 0; i <= posts; ++i) {
        const dvec3 foot = from + (double(i) / posts) * (to - from);
        model.cylinder(foot, foot + rail_height * up, rail_radius);
    }
    for (const double height : {0.55, rail_height}) {
        model.cylinder(from + height * up, to + height * up, rail_radius);
    }
    model.end();
}

void add_ring_platform(Model& model, const RingPlatform& platform) {
    const double inner = platform.vessel_radius + 0.08;
    const double outer = platform.vessel_radius + 1.25;
    const dvec3 from = at_angle(platform.from_angle);
    model.begin("PLATFORM", platform.centre);
    model.use(Finish::grating);
    model.duct_turn({platform.centre - dvec3(0.0, 0.0, 0.03), up, from, platform.arc},
                    {inner, outer}, 0.06);
    const int brackets = std::max(2, static_cast<int>(platform.arc / 0.6));
    for (int i = 0; i <= brackets; ++i) {
        const dvec3 out =
            at_angle(platform.from_angle + platform.arc * (0.04 + 0.92 * i / brackets));
        model.use(Finish::steel);
        model.bar(platform.centre + platform.vessel_radius * out - 0.9 * up,
                  platform.centre + (outer - 0.1) * out - 0.12 * up, 0.08, 0.08);
    }
    model.end();
    model.begin("HANDRAIL", platform.centre);
    model.use(Finish::rail);
    const double radius = outer - 0.04;
    for (const double height : {0.55, rail_height}) {
        model.torus({platform.centre + height * up, up, from, platform.arc}, radius, rail_radius);
    }
    model.duct_turn({platform.centre + 0.075 * up, up, from, platform.arc}, {radius, radius + 0.01},
                    0.15);
    const int posts = std::max(2, static_cast<int>(platform.arc * radius / 1.2));
    for (int i = 0; i <= posts; ++i) {
        const dvec3 foot =
            platform.centre + radius * at_angle(platform.from_angle + platform.arc * i / posts);
        model.cylinder(foot, foot + rail_height * up, rail_radius);
    }
    model.end();
}

void add_platform(Model& model, const dvec3& centre, const glm::dvec2& size) {
    model.begin("PLATFORM", centre);
    const glm::dvec2 half = 0.5 * size;
    for (const double x : {-half.x + 0.15, half.x - 0.15}) {
        for (const double y : {-half.y + 0.15, half.y - 0.15}) {
            model.use(Finish::steel);
            model.box({centre.x + x, centre.y + y, 0.5 * (centre.z - 0.2)},
                      {0.16, 0.16, centre.z - 0.2});
        }
    }
    for (const double y : {-half.y + 0.15, half.y - 0.15}) {
        model.bar(centre + dvec3(-half.x, y, -0.14), centre + dvec3(half.x, y, -0.14), 0.12, 0.18);
    }
    model.use(Finish::grating);
    model.box(centre - dvec3(0.0, 0.0, 0.025), {size.x, size.y, 0.05});
    const dvec3 a = centre + dvec3(-half.x + 0.05, -half.y + 0.05, 0.0);
    const dvec3 c = centre + dvec3(half.x - 0.05, half.y - 0.05, 0.0);
    add_handrail(model, {a.x, a.y, a.z}, {c.x, a.y, a.z});
    add_handrail(model, {c.x, a.y, a.z}, {c.x, c.y, a.z});
    add_handrail(model, {a.x, c.y, a.z}, {c.x, c.y, a.z});
    model.end();
    add_ladder(model, {{a.x, centre.y, 0.0}, centre.z, {-1.0, 0.0, 0.0}, false});
}

}  // namespace quartic
