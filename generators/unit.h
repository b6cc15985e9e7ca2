// One process unit: a rack with its lines in the middle, equipment on both sides, pipes between
// them.
#pragma once

#include "generators/model.h"

#include <cstdint>

namespace quartic {

constexpr double unit_length = 48.0;
constexpr double unit_width = 44.0;

struct UnitPlace {
    glm::dvec3 corner{0.0};      // the unit lies at x, y >= corner
    std::uint64_t row_seed = 0;  // units of one row share their rack's lines
    std::uint64_t unit_seed = 0;
    bool first = true;  // of its row: lines begin with a blind flange
    bool last = true;
    int number = 1;
};

void add_unit(Model& model, const UnitPlace& place);

}  // namespace quartic
