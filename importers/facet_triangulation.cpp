// Projects facets to their plane, cuts convex ones directly and the others by ear clipping.
#include "importers/facet_triangulation.h"

#include <algorithm>
#include <cmath>

namespace quartic {
namespace {

// Newell's method: twice the area as a vector; robust for any plane polygon, also where corners are
// collinear.
glm::dvec3 area_vector(std::span<const glm::dvec3> corners) {
    glm::dvec3 sum(0.0);
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
        sum += glm::cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
    }
    return sum;
}

double extent_of(std::span<const glm::dvec3> corners) {
    glm::dvec3 low = corners[0];
    glm::dvec3 high = corners[0];
    for (const glm::dvec3& corner : corners) {
        low = glm::min(low, corner);
        high = glm::max(high, corner);
    }
    return glm::length(high - low);
}

constexpr double coordinate_max = 1e12;  // in millimetres, as the longest shape

bool all_finite(std::span<const glm::dvec3> corners) {
    return std::all_of(corners.begin(), corners.end(), [](const glm::dvec3& corner) {
        return std::abs(corner.x) <= coordinate_max && std::abs(corner.y) <= coordinate_max &&
               std::abs(corner.z) <= coordinate_max;  // false for NaN
    });
}

FacetFault check(const FacetPolygon& polygon) {
    if (polygon.contour_sizes.empty() || polygon.contour_sizes[0] < 3) {
        return FacetFault::too_few_corners;
    }
    if (polygon.positions.size() > facet_corners_max) {
        return FacetFault::too_many_corners;
    }
    return all_finite(polygon.positions) ? FacetFault::none : FacetFault::not_finite;
}

double cross(glm::dvec2 a, glm::dvec2 b) {
    return a.x * b.y - a.y * b.x;
}

constexpr double no_area = 1e-9;  // of the squared extent: a thousandth of a millimetre on a metre
constexpr double area_tolerance = 1e-3;  // of the polygon's area

}  // namespace

std::string_view text_of(FacetFault fault) {
    switch (fault) {
        case FacetFault::none: return "";
        case FacetFault::too_few_corners: return "a facet of fewer than three corners";
        case FacetFault::no_area: return "a facet without area";
        case FacetFault::not_finite:
            return "a facet with a corner that is not finite or over 1e12 away";
        case FacetFault::too_many_corners: return "a facet of more than 1,048,576 corners";
        case FacetFault::not_filled: return "a facet that crosses itself or has a hole outside";
        case FacetFault::out_of_work: return "a facet too tangled to be cut in the time allowed";
    }
    return "";
}

Severity severity_of(FacetFault fault) {
    switch (fault) {
        case FacetFault::none:
        case FacetFault::too_few_corners:
        case FacetFault::no_area: return Severity::note;
        case FacetFault::not_filled: return Severity::warning;
        case FacetFault::not_finite:
        case FacetFault::too_many_corners:
        case FacetFault::out_of_work: break;
    }
    return Severity::loss;
}

double FacetTriangulation::area_of(std::size_t first, std::size_t count) const {
    double twice = 0.0;
    for (std::size_t i = 1; i + 1 < count; ++i) {
        twice += cross(flat_[first + i] - flat_[first], flat_[first + i + 1] - flat_[first]);
    }
    return 0.5 * twice;
}

// A convex outline, once around: cut in a zigzag, which gives better triangles than a fan. False:
// it is not convex.
bool FacetTriangulation::cut_convex(std::size_t count,
                                    std::vector<std::uint32_t>& triangles) const {
    int turns_of_x = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const glm::dvec2 a = flat_[(i + 1) % count] - flat_[i];
        const glm::dvec2 b = flat_[(i + 2) % count] - flat_[(i + 1) % count];
        if (!(cross(a, b) > 0.0)) {
            return false;
        }
        turns_of_x += (a.x < 0.0) != (b.x < 0.0) ? 1 : 0;
    }
    if (turns_of_x > 2) {
        return false;  // winds around more than once
    }
    std::uint32_t low = 0;
    auto high = static_cast<std::uint32_t>(count - 1);
    for (bool lower = true; low + 1 < high; lower = !lower) {
        triangles.insert(triangles.end(), {low, lower ? low + 1 : high - 1, high});
        low += lower ? 1 : 0;
        high -= lower ? 0 : 1;
    }
    return true;
}

FacetFault FacetTriangulation::cut_flat(const FacetPolygon& polygon,
                                        std::vector<std::uint32_t>& triangles) {
    if (polygon.contour_sizes.size() == 1 && cut_convex(flat_.size(), triangles)) {
        return FacetFault::none;
    }
    ears_.start(flat_.size());
    double area = 0.0;
    std::size_t first = 0;
    for (std::size_t contour = 0; contour < polygon.contour_sizes.size(); ++contour) {
        const std::size_t count = polygon.contour_sizes[contour];
        const double signed_area = count < 3 ? 0.0 : area_of(first, count);
        const std::span<const glm::dvec2> points = std::span(flat_).subspan(first, count);
        const auto name = static_cast<std::uint32_t>(first);
        if (contour == 0) {
            ears_.add_outline(points, name, 1);
            area = signed_area;
        } else if (signed_area != 0.0) {
            ears_.add_hole(points, name, signed_area < 0.0 ? 1 : -1);
            area -= std::abs(signed_area);
        }
        first += count;
    }
    const EarClipping::Report report = ears_.cut(triangles);
    if (report.out_of_work) {
        return FacetFault::out_of_work;
    }
    const bool filled = std::abs(report.area - area) <= area_tolerance * std::abs(area) + 1e-12;
    return filled && report.lost_holes == 0 ? FacetFault::none : FacetFault::not_filled;
}

FacetTriangulation::Cut FacetTriangulation::cut(const FacetPolygon& polygon,
                                                std::vector<std::uint32_t>& triangles) {
    const FacetFault fault = check(polygon);
    if (fault != FacetFault::none) {
        return {fault};
    }
    const std::span<const glm::dvec3> outline = polygon.positions.first(polygon.contour_sizes[0]);
    const glm::dvec3 area = area_vector(outline);
    const double size = glm::length(area);
    const double extent = extent_of(outline);
    if (!(size > no_area * extent * extent)) {
        return {FacetFault::no_area};
    }
    glm::dvec3 normal = area / size;
    const glm::dvec3 aside = std::abs(normal.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    const glm::dvec3 u = glm::normalize(glm::cross(aside, normal));
    const glm::dvec3 v = glm::cross(normal, u);
    flat_.clear();
    for (const glm::dvec3& position : polygon.positions) {
        const glm::dvec3 d = position - polygon.positions[0];
        flat_.emplace_back(glm::dot(d, u), glm::dot(d, v));
    }
    const std::size_t start = triangles.size();
    Cut result{cut_flat(polygon, triangles), normal};
    double agreement = 0.0;
    for (const glm::dvec3& corner_normal : polygon.normals) {
        agreement += glm::dot(corner_normal, normal);
    }
    if (agreement < 0.0) {
        result.normal = -normal;
        for (std::size_t i = start; i + 2 < triangles.size(); i += 3) {
            std::swap(triangles[i + 1], triangles[i + 2]);
        }
    }
    return result;
}

}  // namespace quartic
