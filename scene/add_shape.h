// How importers and generators add shapes: sound ones as they are, those with a zero dimension as
// what is left of them.
#pragma once

#include "scene/scene.h"

#include <string_view>

namespace quartic {

// What became of a shape. The reason is empty for a sound one; it is a constant text, fit for
// Outcome::reason.
struct Added {
    bool drawn = false;  // false: nothing of it can be seen, or its parameters make no sense
    std::string_view reason;
};

// A cylinder, cone, snout or dish of zero height is a disc; one zero radius is a tip; a box or
// pyramid of zero thickness is a flat box; zero radius, zero arc or two zero lengths are nothing.
// Anything else that find_fault() objects to (not finite, negative, a spindle torus, a cut that
// does not close) is refused, with its words as reason. A snout with neither offset nor cuts is
// stored as a cone, a cone of equal radii as a cylinder: the same solids, solved faster.
#define SHAPE(id, Type, name) \
    Added add_shape(Scene& scene, const f64::Type& shape, const Part& part);
#include "primitives/catalog.h"
#undef SHAPE

}  // namespace quartic
