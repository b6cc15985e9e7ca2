// The formulas from RVM parameters to shapes (kinds and frames: docs/formats/rvm.md).
#include "importers/rvm_primitive.h"

#include "importers/baked_mesh.h"
#include "scene/add_shape.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

namespace quartic {
namespace {

constexpr double local_unit = 0.001;   // metres, where the matrix does not say
constexpr double line_radius = 0.001;  // metres, of a line that gives no thickness
constexpr double line_radius_max = 0.005;
constexpr double full_turn = 2.0 * std::numbers::pi;
constexpr double full_turn_tolerance = 1e-5;  // five decimals in the text form; floats are closer

using Parameters = std::array<double, 9>;

Parameters parameters_of(const RvmPrimitive& primitive) {
    Parameters p{};
    for (std::size_t i = 0; i < p.size(); ++i) {
        p[i] = static_cast<double>(primitive.values[i]);
    }
    return p;
}

// A full turn that rounding made longer or shorter is a full turn.
double arc_of(double angle) {
    return std::abs(angle - full_turn) <= full_turn_tolerance ? full_turn : angle;
}

double box_extent(const RvmPrimitive& primitive, std::size_t axis) {
    return static_cast<double>(primitive.box[axis + 3]) - static_cast<double>(primitive.box[axis]);
}

// Readers disagree whether the number is the radius or the diameter; the stored box is exact for
// spheres.
double sphere_radius(const RvmPrimitive& primitive, double value) {
    const double half_extent = 0.5 * box_extent(primitive, 0);
    const bool is_radius = std::abs(value - half_extent) < std::abs(value - 2.0 * half_extent);
    return std::isfinite(half_extent) && is_radius ? value : 0.5 * value;
}

// A rod along local z. PDMS writes its length as the second number, E3D only into the box.
f64::Cylinder line_rod(const RvmPrimitive& primitive, const Parameters& p, double scale) {
    const double length = std::isfinite(p[1]) && p[1] > 0.0 ? p[1] : box_extent(primitive, 2);
    const double radius = std::isfinite(p[0]) && p[0] > 0.0 ? p[0] * scale : line_radius;
    f64::Cylinder rod{};
    rod.radius = std::min(radius, line_radius_max);
    rod.height = length * scale;
    return rod;
}

// Turns the frame about z so that the offset lies along +x; the slopes of the cuts turn with it.
Added add_snout(Scene& scene, const Parameters& p, double scale, Part part) {
    const double offset = std::hypot(p[3], p[4]);
    const double c = offset > 0.0 ? p[3] / offset : 1.0;
    const double s = offset > 0.0 ? p[4] / offset : 0.0;
    const double slopes[4] = {std::tan(p[5]), std::tan(p[6]), std::tan(p[7]), std::tan(p[8])};
    f64::Snout snout{};
    snout.bottom_radius = p[0] * scale;
    snout.top_radius = p[1] * scale;
    snout.height = p[2] * scale;
    snout.offset = offset * scale;
    snout.bottom_slope_x = c * slopes[0] + s * slopes[1];
    snout.bottom_slope_y = c * slopes[1] - s * slopes[0];
    snout.top_slope_x = c * slopes[2] + s * slopes[3];
    snout.top_slope_y = c * slopes[3] - s * slopes[2];
    if (s != 0.0 || c < 0.0) {
        const double half = 0.5 * std::atan2(s, c);
        part.placement.rotation = glm::normalize(
            part.placement.rotation * glm::dquat(std::cos(half), 0.0, 0.0, std::sin(half)));
    }
    return add_shape(scene, snout, part);
}

Added add_pyramid(Scene& scene, const Parameters& p, double scale, const Part& part) {
    f64::Pyramid pyramid{};
    pyramid.bottom_x = p[0] * scale;
    pyramid.bottom_y = p[1] * scale;
    pyramid.top_x = p[2] * scale;
    pyramid.top_y = p[3] * scale;
    pyramid.offset_x = p[4] * scale;
    pyramid.offset_y = p[5] * scale;
    pyramid.height = p[6] * scale;
    return add_shape(scene, pyramid, part);
}

Added add_line(Scene& scene, const RvmPrimitive& primitive, const Parameters& p, double scale,
               const Part& part) {
    const f64::Cylinder rod = line_rod(primitive, p, scale);
    return rod.height > 0.0 ? add_shape(scene, rod, part) : Added{false, "a line without length"};
}

// The one table of what each kind is.
Added add_analytic(Scene& scene, const RvmPrimitive& primitive, double scale, const Part& part) {
    const Parameters p = parameters_of(primitive);
    const double k = scale;
    switch (primitive.kind) {
        case RvmKind::pyramid: return add_pyramid(scene, p, k, part);
        case RvmKind::box:
            return add_shape(scene, f64::Box{p[0] * k, p[1] * k, p[2] * k, 0.0}, part);
        case RvmKind::rectangular_torus:
            return add_shape(
                scene, f64::RectangularTorus{p[0] * k, p[1] * k, p[2] * k, arc_of(p[3])}, part);
        case RvmKind::circular_torus:
            return add_shape(scene, f64::Torus{p[0] * k, p[1] * k, arc_of(p[2]), 0.0}, part);
        case RvmKind::elliptical_dish:
            return add_shape(scene, f64::Dish{p[0] * k, p[1] * k, 0.0, 0.0}, part);
        case RvmKind::spherical_dish:
            return add_shape(scene, f64::Dish{p[0] * k, p[1] * k, 1.0, 0.0}, part);
        case RvmKind::snout: return add_snout(scene, p, k, part);
        case RvmKind::cylinder:
            return add_shape(scene, f64::Cylinder{p[0] * k, p[1] * k, 0.0, 0.0}, part);
        case RvmKind::sphere:
            return add_shape(scene, f64::Sphere{sphere_radius(primitive, p[0]) * k, 0.0, 0.0, 0.0},
                             part);
        case RvmKind::line: return add_line(scene, primitive, p, k, part);
        case RvmKind::facet_group: break;
    }
    return {false, "an unknown kind"};
}

// Whether nothing is lost where nothing is drawn: some size is zero, and none is wrong.
bool is_empty(const RvmPrimitive& primitive) {
    const std::size_t count = rvm_parameter_counts[static_cast<std::size_t>(primitive.kind)];
    const bool line = primitive.kind == RvmKind::line;
    bool has_zero = line && !(box_extent(primitive, 2) < 0.0);
    for (std::size_t i = 0; i < count; ++i) {
        const float value = primitive.values[i];
        const bool is_length = (primitive.kind != RvmKind::snout || i < 3) &&
                               (primitive.kind != RvmKind::pyramid || i < 4 || i == 6);
        if (!std::isfinite(value) || (is_length && value < 0.0f)) {
            return false;
        }
        has_zero = has_zero || (is_length && value == 0.0f);
    }
    return has_zero;
}

// Corners that baked shapes of one block of a file may have before they get coarser: some 50 MB.
constexpr std::size_t fine_corners_max = std::size_t{1} << 21;
constexpr double fine_sagitta = 0.0005;  // metres
constexpr double fine_part = 1e-3;       // of the radius, where that is more
constexpr double coarse_part = 0.1;

double radius_of(const RvmPrimitive& primitive) {
    const Parameters p = parameters_of(primitive);
    switch (primitive.kind) {
        case RvmKind::rectangular_torus: return p[1];
        case RvmKind::circular_torus: return p[1];
        case RvmKind::snout: return std::max(p[0], p[1]);
        default: return p[0];
    }
}

}  // namespace

void RvmFacets::clear() {
    contour_counts.clear();
    contour_sizes.clear();
    positions.clear();
    normals.clear();
}

Layer rvm_layer(RvmKind kind, Layer chunk_layer) {
    return kind == RvmKind::line ? Layer::line : chunk_layer;
}

void RvmConverter::add(const RvmPrimitive& primitive, Part part, std::uint64_t place) {
    const RvmKindName kind = rvm_kind_name(static_cast<std::uint32_t>(primitive.kind));
    part.kind = static_cast<std::uint8_t>(kind);
    const RvmPlacement placement = read_placement(primitive.matrix, primitive.form);
    if (placement.kind == RvmPlacement::Kind::unusable) {
        tally_.add(kind, Became::skipped, placement.reason, Severity::loss, place);
        return;
    }
    if (placement.kind == RvmPlacement::Kind::general) {
        bake(primitive, placement, part, place);
        return;
    }
    part.placement = placement.placement;
    const Added added = add_analytic(scene_, primitive, placement.scale, part);
    if (added.drawn && added.reason.empty()) {
        tally_.add(kind, Became::analytic);
    } else if (added.drawn) {
        tally_.add(kind, Became::analytic, added.reason, Severity::note, place);
    } else {
        tally_.add(kind, Became::skipped, added.reason,
                   is_empty(primitive) ? Severity::note : Severity::loss, place);
    }
}

// In the frame of add_analytic() at the usual scale.
double RvmConverter::sagitta_for(const RvmPrimitive& primitive) const {
    double radius = radius_of(primitive);
    if (baked_corners_ < fine_corners_max) {
        return std::max(fine_sagitta, fine_part * radius * local_unit);
    }
    for (std::size_t i = 0; i < rvm_parameter_counts[static_cast<std::size_t>(primitive.kind)];
         ++i) {
        radius = std::max(radius, static_cast<double>(primitive.values[i]));
    }
    return std::max(fine_sagitta, coarse_part * radius * local_unit);
}

void RvmConverter::bake(const RvmPrimitive& primitive, const RvmPlacement& placement, Part part,
                        std::uint64_t place) {
    const auto kind = static_cast<RvmKindName>(part.kind);
    Scene scratch;
    const Added added = add_analytic(scratch, primitive, local_unit, part);
    if (!added.drawn) {
        tally_.add(kind, Became::skipped, added.reason,
                   is_empty(primitive) ? Severity::note : Severity::loss, place);
        return;
    }
    const double sagitta = sagitta_for(primitive);
    const glm::dmat3 axes = placement.axes / local_unit;
    for (const Part& shape : scratch.parts) {
        const Triangles triangles = triangles_of_part(scratch, shape, sagitta);
        glm::dvec3 centre(0.0);
        Mesh mesh = baked_mesh(triangles, axes, centre);
        baked_corners_ += mesh.positions.size();
        part.placement.position = placement.placement.position + centre;
        add_mesh_part(scene_, std::move(mesh), part);
    }
    // No direction is stretched by more than the matrix's Frobenius norm.
    tally_.deviates(sagitta * std::sqrt(glm::dot(axes[0], axes[0]) + glm::dot(axes[1], axes[1]) +
                                        glm::dot(axes[2], axes[2])));
    tally_.add(kind, Became::tessellated, placement.reason, Severity::warning, place);
}

// Cuts all polygons of a group into all_facets_; true where something was lost.
bool RvmConverter::cut_facets(const RvmFacets& facets, std::uint64_t place) {
    Triangles& all = all_facets_;
    all.positions.clear();
    all.normals.clear();
    all.indices.clear();
    bool loses = false;
    std::size_t first_contour = 0;
    std::size_t first = 0;
    for (const std::uint32_t contours : facets.contour_counts) {
        const auto sizes = std::span(facets.contour_sizes).subspan(first_contour, contours);
        const std::size_t count = std::accumulate(sizes.begin(), sizes.end(), std::size_t{0});
        const FacetPolygon polygon{std::span(facets.positions).subspan(first, count),
                                   std::span(facets.normals).subspan(first, count), sizes};
        first_contour += contours;
        first += count;
        triangles_.clear();
        const FacetTriangulation::Cut cut = triangulation_.cut(polygon, triangles_);
        if (cut.fault != FacetFault::none) {
            tally_.notice(severity_of(cut.fault), text_of(cut.fault), place);
            loses = loses || severity_of(cut.fault) == Severity::loss;
        }
        if (triangles_.empty()) {
            continue;
        }
        const auto base = static_cast<std::uint32_t>(all.positions.size());
        all.positions.insert(all.positions.end(), polygon.positions.begin(),
                             polygon.positions.end());
        for (const glm::dvec3& normal : polygon.normals) {
            all.normals.emplace_back(unit_or(normal, cut.normal));
        }
        for (const std::uint32_t index : triangles_) {
            all.indices.push_back(base + index);
        }
    }
    return loses;
}

void RvmConverter::add_facets(const RvmPrimitive& primitive, const RvmFacets& facets, Part part,
                              std::uint64_t place) {
    const RvmKindName kind = RvmKindName::facet_group;
    part.kind = static_cast<std::uint8_t>(kind);
    const RvmPlacement placement = read_placement(primitive.matrix, primitive.form);
    if (placement.kind == RvmPlacement::Kind::unusable) {
        tally_.add(kind, Became::skipped, placement.reason, Severity::loss, place);
        return;
    }
    const bool loses = cut_facets(facets, place);
    if (all_facets_.indices.empty()) {
        tally_.add(kind, Became::skipped, "no facet with area",
                   loses ? Severity::loss : Severity::note, place);
        return;
    }
    const bool similar = placement.kind == RvmPlacement::Kind::similar;
    const glm::dmat3 axes = similar ? glm::dmat3(placement.scale) : placement.axes;
    glm::dvec3 centre(0.0);
    Mesh mesh = baked_mesh(all_facets_, axes, centre);
    part.placement.rotation = placement.placement.rotation;
    part.placement.position = placement.placement.position + part.placement.rotation * centre;
    add_mesh_part(scene_, std::move(mesh), part);
    if (similar) {
        tally_.add(kind, Became::triangles);
    } else {
        tally_.add(kind, Became::triangles, placement.reason, Severity::warning, place);
    }
}

}  // namespace quartic
