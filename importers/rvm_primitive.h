// One RVM primitive, read from either file form, and what it becomes in the scene.
#pragma once

#include "importers/facet_triangulation.h"
#include "importers/rvm_placement.h"
#include "importers/rvm_tally.h"
#include "primitives/tessellate.h"
#include "scene/scene.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace quartic {

// The numbers of the file; anything else is unknown.
enum class RvmKind : std::uint8_t {
    pyramid = 1,
    box = 2,
    rectangular_torus = 3,
    circular_torus = 4,
    elliptical_dish = 5,
    spherical_dish = 6,
    snout = 7,
    cylinder = 8,
    sphere = 9,
    line = 10,
    facet_group = 11,
};
constexpr std::uint32_t rvm_kind_end = 12;

// How many parameters a kind has; a facet group's depend on its contents.
constexpr std::array<std::uint8_t, rvm_kind_end> rvm_parameter_counts{0, 7, 3, 4, 3, 2,
                                                                      2, 9, 2, 1, 2, 0};

// Local units (mm), radians.
struct RvmPrimitive {
    RvmKind kind = RvmKind::cylinder;
    MatrixForm form = MatrixForm::binary;
    std::array<float, 12> matrix{};
    std::array<float, 6> box{};  // low, high: no bounds, only a hint (spheres and lines)
    std::array<float, 9> values{};
};

// The polygons of a facet group, flat: contour sizes and corners lie one after another.
struct RvmFacets {
    std::vector<std::uint32_t> contour_counts;  // of each polygon
    std::vector<std::uint32_t> contour_sizes;   // corners of each contour
    std::vector<glm::dvec3> positions;          // local units
    std::vector<glm::dvec3> normals;

    void clear();
};

// Converts primitives one after another; keeps scratch memory. Node, material and layer come in the
// part; where a matrix cannot be placed as a rigid motion, the shape is baked as triangles.
class RvmConverter {
public:
    RvmConverter(Scene& scene, RvmTally& tally) : scene_(scene), tally_(tally) {}

    // For every kind but facet groups. The place names the element in findings.
    void add(const RvmPrimitive& primitive, Part part, std::uint64_t place);
    void add_facets(const RvmPrimitive& primitive, const RvmFacets& facets, Part part,
                    std::uint64_t place);

private:
    void bake(const RvmPrimitive& primitive, const RvmPlacement& placement, Part part,
              std::uint64_t place);
    bool cut_facets(const RvmFacets& facets, std::uint64_t place);
    double sagitta_for(const RvmPrimitive& primitive) const;

    Scene& scene_;
    RvmTally& tally_;
    FacetTriangulation triangulation_;
    std::vector<std::uint32_t> triangles_;
    Triangles all_facets_;  // of one group
    std::size_t baked_corners_ = 0;
};

// The layer of an element: lines have their own, whatever the chunk.
Layer rvm_layer(RvmKind kind, Layer chunk_layer);

}  // namespace quartic
