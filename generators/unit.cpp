// Lanes on the rack, slots beside it, and routes from nozzles to lanes.
#include "generators/unit.h"

#include "generators/equipment.h"
#include "generators/steel.h"

#include <algorithm>
#include <cmath>

namespace quartic {
namespace {

using glm::dvec3;

constexpr double rack_width = 7.0;
constexpr double bay = 6.0;
constexpr double levels[] = {5.2, 7.2, 9.0};
constexpr double slot_length = 12.0;
constexpr double slot_distance = 13.0;  // of the equipment's middle from the rack's
constexpr double shoe_height = 0.1;
constexpr double bend_ratios[] = {2.28, 2.52, 2.66, 2.66, 2.72, 3.0, 3.0, 2.0};

// Pipes by service with the radii of their outer walls.
constexpr double radii[] = {0.0302, 0.0446, 0.0572, 0.0842, 0.1095, 0.1366, 0.1619, 0.2032};
constexpr Finish services[] = {
    Finish::process, Finish::process,  Finish::process,   Finish::process, Finish::process,
    Finish::water,   Finish::water,    Finish::steam,     Finish::gas,     Finish::air,
    Finish::air,     Finish::chemical, Finish::fire_water};

struct Lane {
    double y;
    double z;
    double level;
    double radius;
    Finish service;
    bool insulated;
    double bend_ratio;
    bool loops;
};

// The lanes of a row's rack, side by side on each level.
std::vector<Lane> plan_lanes(std::uint64_t row_seed) {
    Random random(row_seed);
    std::vector<Lane> lanes;
    for (const double level : levels) {
        double y = -0.5 * rack_width + 0.35;
        const double last = 0.5 * rack_width - (level > 8.5 ? 2.2 : 0.35);
        while (true) {
            Lane lane;
            lane.radius = random.pick(radii);
            lane.service = random.pick(services);
            lane.insulated = lane.service == Finish::steam || random.chance(0.08);
            const double half = lane.radius + (lane.insulated ? 0.05 : 0.0);
            y += half;
            if (y + half > last) {
                break;
            }
            lane.y = y;
            lane.level = level;
            lane.z = level + shoe_height + lane.radius;
            lane.bend_ratio = random.pick(bend_ratios);
            lane.loops = level > 8.5 && random.chance(0.5);
            lanes.push_back(lane);
            y += half + random.between(0.1, 0.3);
        }
    }
    return lanes;
}

class Unit {
public:
    Unit(Model& model, const UnitPlace& place)
        : model_(model),
          place_(place),
          random_(place.unit_seed),
          lanes_(plan_lanes(place.row_seed)),
          origin_(place.corner + dvec3(0.0, 0.5 * unit_width, 0.0)) {}

    void build();

private:
    using Equipment = std::vector<Nozzle> (*)(Model&, Random&, const dvec3&, double);

    void add_ground();
    void add_unit_rack();
    void add_lane(const Lane& lane, int number);
    void add_shoes(const Lane& lane, int number);
    void add_trays();
    void add_slot(int slot);
    void add_branch(const Nozzle& nozzle);
    std::vector<dvec3> route(const Nozzle& nozzle, const Lane& lane, double radius);

    Model& model_;
    UnitPlace place_;
    Random random_;
    std::vector<Lane> lanes_;
    dvec3 origin_;
    int branches_ = 0;
};

void Unit::add_ground() {
    model_.begin("PAVING", place_.corner);
    model_.use(Finish::ground);
    model_.box(origin_ + dvec3(0.5 * unit_length, 0.0, -0.15),
               {unit_length, unit_width - 2.0, 0.3});
    model_.end();
}

void Unit::add_unit_rack() {
    Rack rack;
    rack.start = origin_;
    rack.length = unit_length;
    rack.width = rack_width;
    rack.bay = bay;
    rack.levels.assign(std::begin(levels), std::end(levels));
    add_rack(model_, rack);
}

void Unit::add_lane(const Lane& lane, int number) {
    PipeSpec spec;
    spec.name = pipe_name(lane.radius, lane.service, 100 * place_.number + number);
    spec.radius = lane.radius;
    spec.service = lane.service;
    spec.insulated = lane.insulated;
    spec.valve_chance = 0.04;
    spec.bend_ratio = lane.bend_ratio;
    const dvec3 start = origin_ + dvec3(0.0, lane.y, lane.z);
    const dvec3 end = start + dvec3(unit_length, 0.0, 0.0);
    std::vector<dvec3> corners{start, end};
    if (lane.loops) {
        // An expansion loop over the middle of the unit.
        const double rise = std::max(1.1, 7.0 * lane.radius);
        const double x = 0.5 * unit_length - 3.0 - lane.y;
        const double wide = 6.0 + 2.0 * lane.y;
        corners = {start,
                   start + dvec3(x, 0.0, 0.0),
                   start + dvec3(x, 0.0, rise),
                   start + dvec3(x + wide, 0.0, rise),
                   start + dvec3(x + wide, 0.0, 0.0),
                   end};
    }
    Pipeline(model_, random_, spec).run(corners);
    if (place_.first) {
        add_blind(model_, {start, {-1.0, 0.0, 0.0}, lane.radius});
    }
    if (place_.last) {
        add_cap(model_, {end, {1.0, 0.0, 0.0}, lane.radius});
    }
}

// What a line stands on at every bent.
void Unit::add_shoes(const Lane& lane, int number) {
    model_.begin("SHOES " + std::to_string(number), origin_ + dvec3(0.0, lane.y, lane.level));
    model_.use(Finish::tray);
    const double height = shoe_height + 0.3 * lane.radius;
    for (double x = 0.5 * bay; x < unit_length; x += bay) {
        const bool under_loop =
            lane.loops && std::abs(x - 0.5 * unit_length) < 3.0 + std::abs(lane.y) + 0.7;
        if (!under_loop) {
            model_.box(origin_ + dvec3(x, lane.y, lane.level + 0.5 * height),
                       {0.3, std::min(0.16, 1.2 * lane.radius), height});
        }
    }
    model_.end();
}

void Unit::add_trays() {
    model_.begin("CABLE TRAYS", origin_);
    model_.use(Finish::tray);
    const double z = levels[2] + 0.15;
    const double middle = 0.5 * unit_length;
    for (const double y : {2.15, 3.0}) {
        model_.box(origin_ + dvec3(middle, y, z), {unit_length, 0.6, 0.02});
        for (const double side : {-0.3, 0.3}) {
            model_.box(origin_ + dvec3(middle, y + side, z + 0.05), {unit_length, 0.02, 0.1});
        }
        for (int i = 0; i < 5; ++i) {  // cables
            const dvec3 place = origin_ + dvec3(0.0, y - 0.2 + 0.09 * i, z + 0.035);
            model_.cylinder(place, place + dvec3(unit_length, 0.0, 0.0), 0.022);
        }
    }
    model_.end();
}

// Out of the nozzle, to a height above the rack, over the lane, and down into it.
std::vector<dvec3> Unit::route(const Nozzle& nozzle, const Lane& lane, double radius) {
    const double reach = 0.5 + 6.0 * radius;
    const double above = origin_.z + lane.z + lane.radius + 0.35 + 4.0 * radius +
                         0.35 * static_cast<double>(random_.whole(0, 2));
    const double y = origin_.y + lane.y;
    std::vector<dvec3> corners{nozzle.position};
    dvec3 at = nozzle.position;
    if (std::abs(nozzle.out.z) < 0.5) {
        at += reach * nozzle.out;
        corners.push_back(at);
    } else if (above - at.z < reach) {
        at.z += reach;  // higher than the rack: over the top and down its side
        corners.push_back(at);
        at += dvec3(random_.chance(0.5) ? 1.9 : -1.9, 0.0, 0.0);
        corners.push_back(at);
    }
    at.z = above;
    corners.push_back(at);
    // Sometimes aside by two equal bends.
    const double room = std::abs(y - at.y);
    if (random_.chance(0.5) && room > 6.0) {
        constexpr double slopes[] = {1.0, 1.0, 0.57735026918962576, 1.7320508075688772};
        const double towards = y > at.y ? 1.0 : -1.0;
        const double aside = random_.chance(0.5) ? 1.2 : -1.2;
        at.y += 2.0 * towards;
        corners.push_back(at);
        at += dvec3(aside, towards * std::abs(aside) / random_.pick(slopes), 0.0);
        corners.push_back(at);
    }
    at.y = y;
    corners.push_back(at);
    at.z = origin_.z + lane.z;
    corners.push_back(at);
    return corners;
}

void Unit::add_branch(const Nozzle& nozzle) {
    std::vector<const Lane*> fitting;  // headers that are not thinner
    for (const Lane& lane : lanes_) {
        if (lane.radius >= nozzle.radius || lane.radius > 0.15) {
            fitting.push_back(&lane);
        }
    }
    if (fitting.empty()) {
        return;
    }
    const Lane& lane = *fitting[random_.next() % fitting.size()];
    PipeSpec spec;
    spec.radius = std::min(nozzle.radius, lane.radius);
    spec.service = lane.service;
    spec.insulated = lane.insulated;
    spec.name = pipe_name(spec.radius, lane.service, 100 * place_.number + 50 + ++branches_);
    spec.valve_chance = 0.4;
    spec.flanged_start = spec.radius == nozzle.radius;
    spec.bend_ratio = random_.pick(bend_ratios);
    Nozzle start = nozzle;
    if (spec.radius < nozzle.radius) {
        start.position += (2.5 * nozzle.radius) * nozzle.out;
        model_.use(lane.service);
        model_.begin("REDUCER 1", nozzle.position);
        model_.reducer({nozzle.position, nozzle.radius}, {start.position, spec.radius}, nozzle.out);
        model_.end();
    }
    const std::vector<dvec3> corners = route(start, lane, spec.radius);
    Pipeline(model_, random_, spec).run(corners);
    model_.begin("TEE 1", corners.back());  // the collar where it enters the header
    const dvec3 foot = corners.back() + dvec3(0.0, 0.0, 0.8 * lane.radius);
    model_.cone({foot, 1.35 * spec.radius},
                {foot + dvec3(0.0, 0.0, 0.3 * lane.radius + 0.6 * spec.radius), spec.radius});
    model_.end();
}

void Unit::add_slot(int slot) {
    constexpr Equipment kinds[] = {add_column_vessel, add_column_vessel, add_drum,       add_drum,
                                   add_legged_drum,   add_exchangers,    add_exchangers, add_pumps,
                                   add_tank,          add_house,         add_coil};
    constexpr const char* tags[] = {"C", "C", "D", "D", "V", "E", "E", "PUMPS", "T", "H", "F"};
    const double side = slot % 2 == 0 ? -1.0 : 1.0;  // towards the rack
    const std::size_t kind = random_.next() % std::size(kinds);
    const double x = slot_length * (slot / 2 + 0.5) + random_.between(-0.6, 0.6);
    const dvec3 foot = origin_ + dvec3(x, -side * slot_distance, 0.0);
    model_.begin(std::string(tags[kind]) + "-" + std::to_string(100 * place_.number + slot), foot);
    model_.attribute("Type", "EQUI");
    const std::vector<Nozzle> nozzles = kinds[kind](model_, random_, foot, side);
    model_.end();
    for (const Nozzle& nozzle : nozzles) {
        if (!model_.is_full()) {
            add_branch(nozzle);
        }
    }
}

void Unit::build() {
    model_.begin("UNIT-" + std::to_string(place_.number), place_.corner);
    add_ground();
    const auto lane_count = static_cast<int>(lanes_.size());
    const int steps = std::max(8, lane_count);
    // Lines and equipment in turn, so that a unit that is not finished has something of both.
    for (int i = 0; i < steps && !model_.is_full(); ++i) {
        if (i < lane_count) {
            const Lane& lane = lanes_[static_cast<std::size_t>(i)];
            add_lane(lane, i + 1);
            add_shoes(lane, i + 1);
        }
        if (i < 8 && !model_.is_full()) {
            add_slot(i);
        }
        if (i == 0 && !model_.is_full()) {
            add_unit_rack();
        }
    }
    if (!model_.is_full()) {
        add_trays();
    }
    model_.end();
}

}  // namespace

void add_unit(Model& model, const UnitPlace& place) {
    Unit(model, place).build();
}

}  // namespace quartic
