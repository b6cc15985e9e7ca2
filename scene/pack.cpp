// Packs a scene: sorts parts along a space-filling curve, cuts chunks, writes float records.
#include "scene/pack.h"

#include "diagnostics/check.h"
#include "scene/gpu_layout.h"
#include "solvers/solver_table.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <numeric>
#include <tuple>

namespace quartic {
namespace {

// OpenGL promises storage blocks of 16 MiB, software renderers give 128 MiB.
constexpr std::uint32_t batch_bytes_max = 127u << 20;
constexpr std::uint32_t batch_parts_max = (1u << gpu::locator_shift) - 1;
constexpr std::size_t batches_max = std::size_t{1} << (32 - gpu::locator_shift);

// Interleaves 21 bits of each coordinate.
std::uint64_t morton_code(const glm::dvec3& unit) {
    std::uint64_t code = 0;
    for (int axis = 0; axis < 3; ++axis) {
        auto bits = static_cast<std::uint64_t>(std::clamp(unit[axis], 0.0, 1.0) * 2097151.0);
        bits = (bits | bits << 32) & 0x1f00000000ffff;
        bits = (bits | bits << 16) & 0x1f0000ff0000ff;
        bits = (bits | bits << 8) & 0x100f00f00f00f00f;
        bits = (bits | bits << 4) & 0x10c30c30c30c30c3;
        bits = (bits | bits << 2) & 0x1249249249249249;
        code |= bits << axis;
    }
    return code;
}

// Positions are rounded to a grid that is the same wherever the model lies, so that moving a model
// moves its picture exactly. Within a chunk the grid is exact in float: it is at most 2^-20 m (a
// micrometre) up to 16 m from the origin.
struct Grid {
    double step;
    double reach;  // of a chunk from its origin

    double round(double x) const { return step * std::round(x / step); }
    glm::dvec3 round(const glm::dvec3& p) const { return {round(p.x), round(p.y), round(p.z)}; }
};

Grid make_grid(const Box3& positions) {
    const glm::dvec3 size = positions.high - positions.low;
    const double extent = std::clamp(std::max({size.x, size.y, size.z}), 1e-6, 16.0);
    const double step = std::exp2(std::floor(std::log2(extent)) - 24.0);
    return {step, step * 16777216.0};
}

int largest_component(const glm::dquat& q) {
    const double components[] = {std::abs(q.x), std::abs(q.y), std::abs(q.z), std::abs(q.w)};
    return static_cast<int>(std::max_element(components, components + 4) - components);
}

gpu::Placement make_placement(const Part& part, std::uint32_t id, const glm::dvec3& position,
                              std::uint32_t chunk) {
    const glm::dquat& q = part.placement.rotation;
    const double components[] = {q.x, q.y, q.z, q.w};
    const int largest = largest_component(q);
    const double sign = components[largest] < 0.0 ? -1.0 : 1.0;
    float rest[3] = {};
    for (int i = 0, kept = 0; i < 4; ++i) {
        if (i != largest) {
            rest[kept++] = static_cast<float>(sign * components[i]);
        }
    }
    gpu::Placement placement{};
    placement.x = static_cast<float>(position.x);
    placement.y = static_cast<float>(position.y);
    placement.z = static_cast<float>(position.z);
    placement.turn_a = rest[0];
    placement.turn_b = rest[1];
    placement.turn_c = rest[2];
    placement.part = id;
    placement.bits = (part.open_ends & gpu::open_ends_mask) |
                     static_cast<std::uint32_t>(part.smooth_ends & 3) << gpu::smooth_ends_shift |
                     static_cast<std::uint32_t>(largest) << gpu::rotation_largest_shift |
                     chunk << gpu::chunk_shift;
    return placement;
}

// A shape has the same scalars in the same order in float and in double.
template <class Float, class Double>
Float narrow(const Double& shape) {
    constexpr std::size_t count = sizeof(Double) / sizeof(double);
    static_assert(sizeof(Float) == count * sizeof(float));
    double wide[count];
    float scalars[count];
    std::memcpy(wide, &shape, sizeof(wide));
    std::transform(wide, wide + count, scalars, [](double x) { return static_cast<float>(x); });
    Float result;
    std::memcpy(&result, scalars, sizeof(result));
    return result;
}

struct FloatShape {
    float scalars[36];
    std::uint32_t bytes = 0;
    int form = 0;
    int hull_rings = 2;
};

// Hulls with a few more rings than they need share a batch.
template <class Shape>
int rings_of(const Shape& shape) {
    if (f32().suits_outline(shape)) {
        return outline_rings;
    }
    const int rings = f32().hull_rings(shape);
    return rings <= 5 ? rings : rings <= 9 ? 9 : rings <= 13 ? 13 : 17;
}

template <class Shape>
int form_of(const Shape& shape, int open_ends) {
    if constexpr (requires { f32().prepare(shape, open_ends); }) {
        const f32::ArcEnds ends = f32().prepare(shape, open_ends);
        return ends.form + (ends.nears_axis ? arc_forms : 0);
    }
    return 0;
}

FloatShape float_shape(const Scene& scene, const Part& part) {
    FloatShape result{};
    if (part.type == ShapeType::mesh) {
        return result;
    }
#define SHAPE(id, Type, name)                                                     \
    if (part.type == ShapeType::name) {                                           \
        const f32::Type shape = narrow<f32::Type>(scene.shapes.name[part.shape]); \
        std::memcpy(result.scalars, &shape, sizeof(shape));                       \
        result.bytes = sizeof(shape);                                             \
        result.hull_rings = rings_of(shape);                                      \
        result.form = form_of(shape, part.open_ends);                             \
    }
#include "primitives/catalog.h"
#undef SHAPE
    return result;
}

class Packer {
public:
    Packer(const Scene& scene, const PackOptions& options) : scene_(scene), options_(options) {}

    Packed run() {
        pack_materials();
        const std::vector<std::uint32_t> order = sorted_parts();
        packed_.bounds.reserve(order.size());
        for (const std::uint32_t id : order) {
            add(id);
        }
        pack_meshes();
        return std::move(packed_);
    }

private:
    void pack_materials() {
        for (const Material& material : scene_.materials) {
            packed_.materials.push_back(material.colour);
        }
        if (packed_.materials.empty()) {
            packed_.materials.push_back(Material().colour);
        }
        packed_.part_materials.reserve(scene_.parts.size());
        for (const Part& part : scene_.parts) {
            packed_.part_materials.push_back(part.material);
        }
    }

    std::vector<std::uint32_t> sorted_parts() {
        Box3 box;
        for (const Part& part : scene_.parts) {
            box.low = glm::min(box.low, part.placement.position);
            box.high = glm::max(box.high, part.placement.position);
        }
        std::vector<std::uint32_t> order(scene_.parts.size());
        std::iota(order.begin(), order.end(), 0u);
        if (order.empty()) {
            return order;
        }
        grid_ = make_grid(box);
        const glm::dvec3 size = glm::max(box.high - box.low, glm::dvec3(1e-9));
        std::vector<std::uint64_t> codes(order.size());
        for (std::size_t i = 0; i < codes.size(); ++i) {
            codes[i] = morton_code((scene_.parts[i].placement.position - box.low) / size);
        }
        std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
            return std::tie(codes[a], a) < std::tie(codes[b], b);
        });
        return order;
    }

    // Opens a new chunk where the part does not fit into the last one.
    Chunk& chunk_of(const glm::dvec3& position) {
        if (!packed_.chunks.empty()) {
            Chunk& last = packed_.chunks.back();
            const glm::dvec3 from = glm::abs(position - last.origin);
            if (last.count < chunk_parts_max && std::max({from.x, from.y, from.z}) < grid_.reach) {
                return last;
            }
        }
        return packed_.chunks.emplace_back(
            Chunk{position, static_cast<std::uint32_t>(packed_.bounds.size()), 0});
    }

    Batch& batch_of(const Part& part, const FloatShape& shape, std::uint32_t& index) {
        const Material* material =
            part.material < scene_.materials.size() ? &scene_.materials[part.material] : nullptr;
        const bool transparent =
            !options_.transparent_as_opaque && material != nullptr && material->colour.a < 1.0f;
        const int solver = solver_of(scene_, part, options_.solver, options_.material_solvers);
        const int rings = shape.hull_rings;
        const auto key = std::tuple(part.type, solver, transparent, shape.form, rings);
        const auto known = batch_index_.find(key);
        const auto bytes = static_cast<std::uint32_t>(sizeof(gpu::Placement)) + shape.bytes;
        if (known != batch_index_.end()) {
            Batch& batch = packed_.batches[known->second];
            if (batch.count < batch_parts_max && batch.records.size() + bytes <= batch_bytes_max) {
                index = known->second;
                return batch;
            }
        }
        index = static_cast<std::uint32_t>(packed_.batches.size());
        CHECK(index < batches_max);
        batch_index_[key] = index;
        return packed_.batches.emplace_back(
            Batch{part.type, solver, transparent, shape.form, rings, 0, bytes, {}});
    }

    void add(std::uint32_t id) {
        const Part& part = scene_.parts[id];
        const Box3 box = world_bounds(scene_, part);
        if (box.empty()) {
            return;
        }
        packed_.box.low = glm::min(packed_.box.low, box.low);
        packed_.box.high = glm::max(packed_.box.high, box.high);
        const glm::dvec3 position = grid_.round(part.placement.position);
        Chunk& chunk = chunk_of(position);
        const FloatShape shape = float_shape(scene_, part);
        std::uint32_t batch_index = 0;
        Batch& batch = batch_of(part, shape, batch_index);

        const gpu::Placement placement =
            make_placement(part, id, position - chunk.origin,
                           static_cast<std::uint32_t>(packed_.chunks.size() - 1));
        const std::size_t at = batch.records.size();
        batch.records.resize(at + batch.record_bytes);
        std::memcpy(batch.records.data() + at, &placement, sizeof(placement));
        std::memcpy(batch.records.data() + at + sizeof(placement), shape.scalars, shape.bytes);

        PackedBounds bounds;
        bounds.centre = glm::vec3(0.5 * (box.low + box.high) - chunk.origin);
        bounds.half_size = glm::vec3(0.5 * (box.high - box.low) * (1.0 + 1e-6));
        bounds.locator = batch_index << gpu::locator_shift | batch.count;
        bounds.layer = static_cast<std::uint32_t>(part.layer);
        packed_.bounds.push_back(bounds);
        if (part.type == ShapeType::mesh) {
            mesh_parts_[batch_index].push_back(part.shape);
        }
        ++batch.count;
        ++chunk.count;
    }

    void pack_meshes() {
        std::vector<PackedMesh> placed;
        for (const Mesh& mesh : scene_.meshes) {
            placed.push_back({static_cast<std::uint32_t>(packed_.indices.size()),
                              static_cast<std::uint32_t>(mesh.indices.size()),
                              static_cast<std::int32_t>(packed_.vertices.size())});
            for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
                packed_.vertices.push_back({mesh.positions[i], mesh.normals[i]});
            }
            packed_.indices.insert(packed_.indices.end(), mesh.indices.begin(), mesh.indices.end());
        }
        for (std::size_t i = 0; i < packed_.batches.size(); ++i) {
            if (packed_.batches[i].type != ShapeType::mesh) {
                continue;
            }
            for (const std::uint32_t shape : mesh_parts_[static_cast<std::uint32_t>(i)]) {
                packed_.meshes.push_back(placed[shape]);
            }
        }
    }

    const Scene& scene_;
    const PackOptions& options_;
    Packed packed_;
    Grid grid_{};
    std::map<std::tuple<ShapeType, int, bool, int, int>, std::uint32_t> batch_index_;
    std::map<std::uint32_t, std::vector<std::uint32_t>> mesh_parts_;
};

}  // namespace

Packed pack(const Scene& scene, const PackOptions& options) {
    return Packer(scene, options).run();
}

}  // namespace quartic
