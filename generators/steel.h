// Structure: racks, platforms, ladders, handrails.
#pragma once

#include "generators/model.h"

namespace quartic {

// A pipe rack along x: bents every few metres, beams at each level.
struct Rack {
    glm::dvec3 start{0.0};  // on the ground, in the middle of the first bent
    double length = 48.0;
    double width = 7.0;
    double bay = 6.0;
    std::vector<double> levels;  // top of steel
};

void add_rack(Model& model, const Rack& rack);

// From the ground or a platform straight up; the rungs face the normal's side.
struct Ladder {
    glm::dvec3 foot;
    double height;
    glm::dvec3 out;  // unit, horizontal: away from what it leans on
    bool caged;
};

void add_ladder(Model& model, const Ladder& ladder);

// A straight handrail of two tubes and posts.
void add_handrail(Model& model, const glm::dvec3& from, const glm::dvec3& to);

// A platform around a vessel: part of a ring, with its handrail and brackets.
struct RingPlatform {
    glm::dvec3 centre;  // at the walking level
    double vessel_radius;
    double from_angle;
    double arc;
};

void add_ring_platform(Model& model, const RingPlatform& platform);

// A rectangular platform on four legs from the ground.
void add_platform(Model& model, const glm::dvec3& centre, const glm::dvec2& size);

}  // namespace quartic
