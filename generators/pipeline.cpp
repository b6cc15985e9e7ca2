// Fillets of a polyline, and what stands between them.
#include "generators/pipeline.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace quartic {
namespace {

constexpr double insulation_thickness = 0.05;
constexpr double straight_min = 1e-4;  // shorter pieces are left out: their ends are one point

}  // namespace

std::string pipe_name(double radius, Finish service, int number) {
    static constexpr const char letters[] = "PSWGFAC";
    const char letter = letters[std::min<std::size_t>(static_cast<std::size_t>(service), 6)];
    const auto size_mm = static_cast<int>(std::lround(radius * 80.0)) * 25;  // a nominal bore
    return "PIPE-" + std::to_string(std::max(25, size_mm)) + "-" + letter + "-" +
           std::to_string(number);
}

Pipeline::Pipeline(Model& model, Random& random, PipeSpec spec)
    : model_(model), random_(random), spec_(std::move(spec)) {}

// The setback of an arc that touches both legs is R tan(d / 2) at a deflection of d.
Pipeline::Bend Pipeline::bend_at(std::span<const glm::dvec3> corners, std::size_t index) const {
    const glm::dvec3 corner = corners[index];
    const glm::dvec3 in = corner - corners[index - 1];
    const glm::dvec3 out = corners[index + 1] - corner;
    const glm::dvec3 a = glm::normalize(in);
    const glm::dvec3 b = glm::normalize(out);
    const double half_tangent = std::tan(0.5 * std::acos(std::clamp(glm::dot(a, b), -1.0, 1.0)));
    Bend bend{corner, corner, 0.0};
    if (half_tangent < 1e-6) {
        return bend;
    }
    const double room = 0.49 * std::min(glm::length(in), glm::length(out));
    bend.bend_radius = std::min(spec_.bend_ratio * spec_.radius, room / half_tangent);
    if (bend.bend_radius < spec_.radius) {
        bend.bend_radius = 0.0;
        return bend;
    }
    bend.start = corner - (bend.bend_radius * half_tangent) * a;
    bend.end = corner + (bend.bend_radius * half_tangent) * b;
    return bend;
}

void Pipeline::run(std::span<const glm::dvec3> corners) {
    model_.use(spec_.service);
    model_.begin(spec_.name, corners.front());
    model_.attribute("Type", "PIPE");
    model_.attribute("Bore",
                     std::to_string(static_cast<int>(std::lround(spec_.radius * 2000.0))) + "mm");
    model_.attribute("Spec", spec_.insulated ? "CS150-INS" : "CS150");
    model_.begin("B1", corners.front());
    glm::dvec3 from = corners.front();
    for (std::size_t i = 1; i < corners.size(); ++i) {
        const bool last = i + 1 == corners.size();
        const Bend bend = last ? Bend{corners[i], corners[i], 0.0} : bend_at(corners, i);
        add_straight(from, bend.start, i == 1, last);
        if (bend.bend_radius > 0.0) {
            add_elbow(bend, glm::normalize(corners[i] - corners[i - 1]),
                      glm::normalize(corners[i + 1] - corners[i]));
        }
        from = bend.end;
    }
    model_.end();
    model_.end();
}

void Pipeline::add_straight(const glm::dvec3& from, const glm::dvec3& to, bool first, bool last) {
    double room = glm::length(to - from);
    if (room < straight_min) {
        return;
    }
    const glm::dvec3 along = (to - from) / room;
    const double flange = flange_pair_length(spec_.radius);
    Station at{from, along, spec_.radius};
    glm::dvec3 end = to;
    if (first && spec_.flanged_start && room > flange) {
        add_flange_pair(model_, at, ++flanges_, true);
        at.position += flange * along;
        room -= flange;
    }
    const bool flanged_end = last && spec_.flanged_end && room > flange;
    if (flanged_end) {
        end -= flange * along;
        room -= flange;
    }
    add_fittings(at, room);
    add_tube(at.position, end);
    if (flanged_end) {
        add_flange_pair(model_, {end, along, spec_.radius}, ++flanges_, true);
    }
}

// Valves and flange pairs with tubes before them; the station moves on, what is left is one more
// tube.
void Pipeline::add_fittings(Station& at, double& room) {
    const double valve = valve_length(spec_.radius);
    const double flange = flange_pair_length(spec_.radius);
    while (room > 2.0 * valve + 0.5) {
        const bool has_valve = random_.chance(spec_.valve_chance);
        const bool has_flange = !has_valve && spec_.flange_every > 0.0 &&
                                (room > spec_.flange_every || since_flange_ > spec_.flange_every);
        if (!has_valve && !has_flange) {
            break;
        }
        const double length = has_valve ? valve : flange;
        const double before =
            std::min(random_.between(0.25, 0.75) * (room - length), spec_.flange_every + 1.0);
        const glm::dvec3 place = at.position + before * at.along;
        add_tube(at.position, place);
        const Station station{place, at.along, spec_.radius};
        if (has_valve) {
            add_valve(model_, station, ++valves_, spindle(at.along));
        } else {
            add_flange_pair(model_, station, ++flanges_, random_.chance(0.5));
        }
        at.position = place + length * at.along;
        room -= before + length;
        since_flange_ = 0.0;
    }
}

glm::dvec3 Pipeline::spindle(const glm::dvec3& along) {
    if (std::abs(along.z) < 0.9) {
        const glm::dvec3 side = glm::normalize(glm::cross(along, glm::dvec3(0.0, 0.0, 1.0)));
        return random_.chance(0.75) ? glm::cross(side, along) : side;
    }
    return random_.chance(0.5) ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0);
}

void Pipeline::add_tube(const glm::dvec3& from, const glm::dvec3& to) {
    if (glm::length(to - from) < straight_min) {
        return;
    }
    since_flange_ += glm::length(to - from);
    model_.begin("TUBE " + std::to_string(++tubes_), from);
    model_.cylinder(from, to, spec_.radius);
    if (spec_.insulated) {
        model_.begin("INSULATION", from);
        model_.use(Finish::insulation);
        model_.use(Layer::insulation);
        model_.cylinder(from, to, spec_.radius + insulation_thickness);
        model_.use(Layer::normal);
        model_.use(spec_.service);
        model_.end();
    }
    model_.end();
}

void Pipeline::add_elbow(const Bend& bend, const glm::dvec3& along, const glm::dvec3& next) {
    const glm::dvec3 inwards = glm::normalize(next - glm::dot(next, along) * along);
    const Turn turn{bend.start + bend.bend_radius * inwards, glm::cross(along, inwards), -inwards,
                    std::acos(std::clamp(glm::dot(along, next), -1.0, 1.0))};
    model_.begin("ELBOW " + std::to_string(++elbows_), bend.start);
    model_.torus(turn, bend.bend_radius, spec_.radius);
    if (spec_.insulated && bend.bend_radius > spec_.radius + insulation_thickness) {
        model_.begin("INSULATION", bend.start);
        model_.use(Finish::insulation);
        model_.use(Layer::insulation);
        model_.torus(turn, bend.bend_radius, spec_.radius + insulation_thickness);
        model_.use(Layer::normal);
        model_.use(spec_.service);
        model_.end();
    }
    model_.end();
}

}  // namespace quartic
