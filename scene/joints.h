// Finds which round ends touch, so that hidden caps need not be drawn and walls join without a
// seam.
#pragma once

#include "scene/scene.h"

namespace quartic {

struct JointCounts {
    std::uint64_t ends = 0;    // round ends in all
    std::uint64_t joined = 0;  // that meet another end
    std::uint64_t open = 0;    // whose cap was found hidden
    std::uint64_t smooth = 0;  // whose wall goes on smoothly
};

// Sets open_ends and smooth_ends of every part. Ends are compared as discs (circle meets circle),
// never by pairs of shapes. Only parts of the same layer and material opacity hide each other's
// caps.
JointCounts find_joints(Scene& scene);

}  // namespace quartic
