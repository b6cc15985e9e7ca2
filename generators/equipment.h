// Vessels, exchangers, pumps and tanks; each tells the nozzles that pipes may be joined to.
#pragma once

#include "generators/pipeline.h"

namespace quartic {

// A tall vessel on a skirt, with platforms and ladders: nozzles at several heights towards -y or
// +y.
std::vector<Nozzle> add_column_vessel(Model& model, Random& random, const glm::dvec3& foot,
                                      double side);
// A drum on saddles, along x.
std::vector<Nozzle> add_drum(Model& model, Random& random, const glm::dvec3& foot, double side);
// A vertical drum on legs.
std::vector<Nozzle> add_legged_drum(Model& model, Random& random, const glm::dvec3& foot,
                                    double side);
// Two exchangers, one above the other, along y.
std::vector<Nozzle> add_exchangers(Model& model, Random& random, const glm::dvec3& foot,
                                   double side);
// A row of pumps on plinths.
std::vector<Nozzle> add_pumps(Model& model, Random& random, const glm::dvec3& foot, double side);
// A storage tank with a domed roof.
std::vector<Nozzle> add_tank(Model& model, Random& random, const glm::dvec3& foot, double side);
// A compressor house with ducts on its roof.
std::vector<Nozzle> add_house(Model& model, Random& random, const glm::dvec3& foot, double side);

// A heater's coil of parallel tubes and return bends in a frame.
std::vector<Nozzle> add_coil(Model& model, Random& random, const glm::dvec3& foot, double side);

}  // namespace quartic
