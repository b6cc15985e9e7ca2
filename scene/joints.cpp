// Matches ends through a hash grid of their centres.
#include "scene/joints.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace quartic {
namespace {

// Ends farther apart than this are not joined: the walls of open ends overlap by half of it each
// (joint_overlap_max in primitives/ray.glsl), so a wider gap would let the eye in.
constexpr double gap_max_m = 1e-4;
constexpr double gap_of_radius_max = 0.02;
constexpr double radius_slack =
    1.001;  // an end hides a neighbour's cap that is wider by this at the most
constexpr double facing_cosine = -0.9999995;  // normals opposite within 0.06 degrees
constexpr double flare_slack = 1e-3;

struct PlacedEnd {
    glm::dvec3 centre;
    glm::dvec3 normal;
    double radius;
    double flare;
    std::uint32_t part;
    std::uint32_t index;
};

std::vector<PlacedEnd> ends_of(const Scene& scene) {
    std::vector<PlacedEnd> ends;
    for (std::uint32_t id = 0; id < scene.parts.size(); ++id) {
        const Part& part = scene.parts[id];
        if (part.type == ShapeType::mesh || part.layer == Layer::line) {
            continue;
        }
        visit_shape(scene.shapes, part.type, part.shape, [&](const auto& shape) {
            f64 kernel;
            for (int i = 0; i < kernel.end_count(shape); ++i) {
                const f64::End end = kernel.end(shape, i);
                if (end.radius > 0.0) {
                    ends.push_back({part.placement.position + part.placement.rotation * end.centre,
                                    part.placement.rotation * end.normal, end.radius, end.flare, id,
                                    static_cast<std::uint32_t>(i)});
                }
            }
        });
    }
    return ends;
}

// Cells of one gap's width: ends that may be joined lie in the same or in neighbouring cells.
struct CellKey {
    std::int64_t x, y, z;
    bool operator==(const CellKey&) const = default;
};
struct CellHash {
    std::size_t operator()(const CellKey& key) const {
        const auto mix = [](std::uint64_t h, std::int64_t v) {
            return (h ^ static_cast<std::uint64_t>(v)) * 0x9e3779b97f4a7c15u;
        };
        return mix(mix(mix(1, key.x), key.y), key.z) >> 7;
    }
};

CellKey cell_of(const glm::dvec3& p) {
    constexpr double cell_m = 2.0 * gap_max_m;
    return {static_cast<std::int64_t>(std::floor(p.x / cell_m)),
            static_cast<std::int64_t>(std::floor(p.y / cell_m)),
            static_cast<std::int64_t>(std::floor(p.z / cell_m))};
}

bool is_opaque(const Scene& scene, const Part& part) {
    return part.material >= scene.materials.size() ||
           scene.materials[part.material].colour.a >= 1.0f;
}

bool may_join(const Scene& scene, const PlacedEnd& a, const PlacedEnd& b) {
    const Part& part_a = scene.parts[a.part];
    const Part& part_b = scene.parts[b.part];
    const double gap = glm::distance(a.centre, b.centre);
    return a.part != b.part && part_a.layer == part_b.layer &&
           is_opaque(scene, part_a) == is_opaque(scene, part_b) &&
           gap <= std::min(gap_max_m, gap_of_radius_max * std::min(a.radius, b.radius)) &&
           glm::dot(a.normal, b.normal) < facing_cosine;
}

}  // namespace

JointCounts find_joints(Scene& scene) {
    const std::vector<PlacedEnd> ends = ends_of(scene);
    std::unordered_multimap<CellKey, std::uint32_t, CellHash> cells;
    cells.reserve(ends.size());
    for (std::uint32_t i = 0; i < ends.size(); ++i) {
        cells.emplace(cell_of(ends[i].centre), i);
    }
    for (Part& part : scene.parts) {
        part.open_ends = 0;
        part.smooth_ends = 0;
    }
    JointCounts counts;
    counts.ends = ends.size();
    for (const PlacedEnd& end : ends) {
        bool joined = false;
        bool open = false;
        bool smooth = false;
        const CellKey home = cell_of(end.centre);
        for (int neighbour = 0; neighbour < 27; ++neighbour) {
            const CellKey key{home.x + neighbour % 3 - 1, home.y + neighbour / 3 % 3 - 1,
                              home.z + neighbour / 9 - 1};
            const auto [first, last] = cells.equal_range(key);
            for (auto at = first; at != last; ++at) {
                const PlacedEnd& other = ends[at->second];
                if (!may_join(scene, end, other)) {
                    continue;
                }
                joined = true;
                open = open || end.radius <= radius_slack * other.radius;
                const bool same_circle =
                    std::abs(end.radius - other.radius) <= (radius_slack - 1.0) * end.radius;
                smooth = smooth || (same_circle && std::abs(end.flare + other.flare) < flare_slack);
            }
        }
        const auto bit = static_cast<std::uint8_t>(1u << end.index);
        scene.parts[end.part].open_ends |= open ? bit : std::uint8_t{0};
        scene.parts[end.part].smooth_ends |= smooth ? bit : std::uint8_t{0};
        counts.joined += joined;
        counts.open += open;
        counts.smooth += smooth;
    }
    return counts;
}

}  // namespace quartic
