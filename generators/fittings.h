// Flanges, valves and what else is set into a straight pipe.
#pragma once

#include "generators/model.h"
#include "generators/random.h"

namespace quartic {

// A place on the axis of a pipe, and where it goes on.
struct Station {
    glm::dvec3 position;
    glm::dvec3 along;
    double radius;
};

double flange_pair_length(double radius);
double valve_length(double radius);

// Each stands from the station on, over its length, and is a node of its own.
void add_flange_pair(Model& model, const Station& station, int number, bool bolted);
void add_valve(Model& model, const Station& station, int number, const glm::dvec3& up);

// A blind flange, or a cap, after the end of a pipe.
void add_cap(Model& model, const Station& station);
void add_blind(Model& model, const Station& station);

}  // namespace quartic
