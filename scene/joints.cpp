// Matches ends through a hash grid of their centres.
#include "scene/joints.h"

#include <algorithm>
#include <cmath>
#include <compare>
#include <tuple>
#include <unordered_map>

namespace quartic {
namespace {

// Ends farther apart than this are not joined: each wall of a joint goes on for as much beyond its
// open end (joint_overlap_max in primitives/ray.glsl), so a wider gap would let the eye in.
constexpr double gap_max_m = 5e-5;
constexpr double gap_of_radius_max = 0.01;
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

// Cells far wider than a gap: ends that may be joined nearly always lie in one.
constexpr double cell_m = 200.0 * gap_max_m;

struct CellKey {
    std::int64_t x, y, z;
    auto operator<=>(const CellKey&) const = default;
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
    return {static_cast<std::int64_t>(std::floor(p.x / cell_m)),
            static_cast<std::int64_t>(std::floor(p.y / cell_m)),
            static_cast<std::int64_t>(std::floor(p.z / cell_m))};
}

// Ends by their cells, those of one cell in the order of their parts.
class EndGrid {
public:
    explicit EndGrid(const std::vector<PlacedEnd>& ends) : ends_(ends), order_(ends.size()) {
        std::vector<CellKey> keys(ends.size());
        for (std::uint32_t i = 0; i < ends.size(); ++i) {
            order_[i] = i;
            keys[i] = cell_of(ends[i].centre);
        }
        std::sort(order_.begin(), order_.end(), [&](std::uint32_t a, std::uint32_t b) {
            return std::tie(keys[a], a) < std::tie(keys[b], b);
        });
        for (std::uint32_t i = 0; i < order_.size(); ++i) {
            Run& run = runs_.try_emplace(keys[order_[i]], Run{i, 0}).first->second;
            ++run.count;
        }
    }

    // Calls visitor with every end within a gap of p, and some farther ones, until it returns true.
    template <class Visitor>
    void find_near(const glm::dvec3& p, Visitor&& visitor) const {
        const CellKey low = cell_of(p - gap_max_m);
        const CellKey high = cell_of(p + gap_max_m);
        for (CellKey key = low; key.x <= high.x; ++key.x) {
            for (key.y = low.y; key.y <= high.y; ++key.y) {
                for (key.z = low.z; key.z <= high.z; ++key.z) {
                    if (visit_cell(key, visitor)) {
                        return;
                    }
                }
            }
        }
    }

private:
    struct Run {
        std::uint32_t first;
        std::uint32_t count;
    };

    template <class Visitor>
    bool visit_cell(const CellKey& key, Visitor& visitor) const {
        const auto run = runs_.find(key);
        if (run == runs_.end()) {
            return false;
        }
        for (std::uint32_t i = 0; i < run->second.count; ++i) {
            if (visitor(ends_[order_[run->second.first + i]])) {
                return true;
            }
        }
        return false;
    }

    const std::vector<PlacedEnd>& ends_;
    std::vector<std::uint32_t> order_;
    std::unordered_map<CellKey, Run, CellHash> runs_;
};

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

// What the ends near one end do to it.
struct Joint {
    bool joined = false;
    bool open = false;
    bool smooth = false;
};

Joint joint_of(const Scene& scene, const EndGrid& grid, const PlacedEnd& end) {
    Joint joint;
    grid.find_near(end.centre, [&](const PlacedEnd& other) {
        if (may_join(scene, end, other)) {
            const bool same_circle =
                std::abs(end.radius - other.radius) <= (radius_slack - 1.0) * end.radius;
            joint.joined = true;
            joint.open = joint.open || end.radius <= radius_slack * other.radius;
            joint.smooth =
                joint.smooth || (same_circle && std::abs(end.flare + other.flare) < flare_slack);
        }
        return joint.open && joint.smooth;
    });
    return joint;
}

}  // namespace

JointCounts find_joints(Scene& scene) {
    const std::vector<PlacedEnd> ends = ends_of(scene);
    const EndGrid grid(ends);
    for (Part& part : scene.parts) {
        part.open_ends = 0;
        part.smooth_ends = 0;
    }
    JointCounts counts;
    counts.ends = ends.size();
    for (const PlacedEnd& end : ends) {
        const Joint joint = joint_of(scene, grid, end);
        const auto bit = static_cast<std::uint8_t>(1u << end.index);
        scene.parts[end.part].open_ends |= joint.open ? bit : std::uint8_t{0};
        scene.parts[end.part].smooth_ends |= joint.smooth ? bit : std::uint8_t{0};
        counts.joined += joint.joined;
        counts.open += joint.open;
        counts.smooth += joint.smooth;
    }
    return counts;
}

}  // namespace quartic
