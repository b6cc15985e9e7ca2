// Famous algebraic surfaces of degree 3 and 4, with the points where they are singular.
#pragma once

#include "scene/polynomial3.h"

#include <span>
#include <string_view>
#include <vector>

namespace quartic {

struct GallerySurface {
    std::string_view name;
    int degree = 0;
    std::string_view source;
    Polynomial3 original;    // in the coordinates of the source
    Polynomial3 polynomial;  // moved and scaled so that it fills the cube [-1, 1]^3
    // In the cube; of singular lines some points, those that are worse (pinch points) among them.
    std::vector<glm::dvec3> singular_points;
};

// The cubics, then the quartics.
std::span<const GallerySurface> gallery();

// The surface of that name, or null.
const GallerySurface* find_in_gallery(std::string_view name);

}  // namespace quartic
