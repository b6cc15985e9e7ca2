// A flat polygon in space, with holes and a normal for each corner, to triangles that wind like the
// normals.
#pragma once

#include "diagnostics/findings.h"
#include "importers/ear_clipping.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace quartic {

// A polygon with more corners is refused; the largest seen in plant files has some hundreds.
constexpr std::size_t facet_corners_max = std::size_t{1} << 20;

// The first contour is the outline, the others are holes; any winding. Positions and normals lie
// contour by contour.
struct FacetPolygon {
    std::span<const glm::dvec3> positions;
    std::span<const glm::dvec3> normals;
    std::span<const std::uint32_t> contour_sizes;
};

enum class FacetFault : std::uint8_t {
    none,
    too_few_corners,   // fewer than three: nothing to draw
    no_area,           // nothing to draw
    not_finite,        // left out
    too_many_corners,  // left out
    not_filled,   // crosses itself or has a hole outside: drawn, but not all of it, or some of it
                  // twice
    out_of_work,  // so tangled that cutting it would take too long: drawn in part
};

std::string_view text_of(FacetFault fault);
Severity severity_of(FacetFault fault);

// Reusable, so that small polygons allocate nothing.
class FacetTriangulation {
public:
    struct Cut {
        FacetFault fault = FacetFault::none;
        glm::dvec3 normal{
            0.0};  // unit, on the side of the corners' normals; zero where there is no area
    };

    // Appends triples of indices into the polygon's corners.
    Cut cut(const FacetPolygon& polygon, std::vector<std::uint32_t>& triangles);

private:
    FacetFault cut_flat(const FacetPolygon& polygon, std::vector<std::uint32_t>& triangles);
    bool cut_convex(std::size_t count, std::vector<std::uint32_t>& triangles) const;
    double area_of(std::size_t first, std::size_t count) const;

    EarClipping ears_;
    std::vector<glm::dvec2> flat_;
};

}  // namespace quartic
