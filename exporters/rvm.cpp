// The tree of groups, primitives and colours as RVM chunks (docs/formats/rvm.md).
#include "exporters/rvm.h"

#include "exporters/rvm_records.h"
#include "exporters/rvm_writer.h"
#include "primitives/tessellate.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <span>

namespace quartic {
namespace {

// Indices of items by the owner that each names, in order: items of owner i stand from starts[i] to
// starts[i + 1].
struct Grouping {
    std::vector<std::uint32_t> starts;
    std::vector<std::uint32_t> items;

    std::span<const std::uint32_t> of(std::size_t owner) const {
        return std::span(items).subspan(starts[owner], starts[owner + 1] - starts[owner]);
    }
};

// Owner of item i by owner_of(i); those without one (no_index) belong to number owner_count.
template <class OwnerOf>
Grouping group(std::size_t item_count, std::size_t owner_count, OwnerOf owner_of) {
    const auto place = [&](std::size_t item) {
        const std::uint32_t owner = owner_of(item);
        return owner == no_index ? owner_count : std::size_t{owner};
    };
    Grouping grouping;
    grouping.starts.assign(owner_count + 2, 0);
    for (std::size_t i = 0; i < item_count; ++i) {
        ++grouping.starts[place(i) + 1];
    }
    for (std::size_t i = 0; i + 1 < grouping.starts.size(); ++i) {
        grouping.starts[i + 1] += grouping.starts[i];
    }
    grouping.items.resize(item_count);
    std::vector<std::uint32_t> next = grouping.starts;
    for (std::size_t i = 0; i < item_count; ++i) {
        grouping.items[next[place(i)]++] = static_cast<std::uint32_t>(i);
    }
    return grouping;
}

// IEC 61966-2-1, section 5.2.
std::uint32_t srgb_byte(float linear) {
    const double value = std::clamp(static_cast<double>(linear), 0.0, 1.0);
    const double srgb =
        value <= 0.0031308 ? 12.92 * value : 1.055 * std::pow(value, 1.0 / 2.4) - 0.055;
    return static_cast<std::uint32_t>(std::lround(255.0 * srgb));
}

// The colours of the materials, each once, numbered from 1 in the order of the materials.
class Palette {
public:
    explicit Palette(const std::vector<Material>& materials) {
        for (const Material& material : materials) {
            const std::uint32_t rgb = (srgb_byte(material.colour.r) << 16) |
                                      (srgb_byte(material.colour.g) << 8) |
                                      srgb_byte(material.colour.b);
            const auto [entry, added] =
                numbers_.try_emplace(rgb, static_cast<std::uint32_t>(colours_.size() + 1));
            if (added) {
                colours_.push_back(rgb);
            }
            indices_.push_back(entry->second);
            const double alpha = std::clamp(static_cast<double>(material.colour.a), 0.0, 1.0);
            transparencies_.push_back(
                static_cast<std::uint8_t>(std::lround(100.0 * (1.0 - alpha))));
        }
    }

    std::uint32_t index(std::uint32_t material) const { return indices_[material]; }
    std::uint8_t transparency(std::uint32_t material) const { return transparencies_[material]; }
    const std::vector<std::uint32_t>& colours() const { return colours_; }

private:
    std::map<std::uint32_t, std::uint32_t> numbers_;
    std::vector<std::uint32_t> colours_;
    std::vector<std::uint32_t> indices_;
    std::vector<std::uint8_t> transparencies_;
};

// RVM has no word for surfaces that are given by an equation: they become facets.
template <class Shape>
double rvm_sagitta(const Shape& shape) {
    return std::max(0.0005, 1e-3 * shape.half_size);
}

class Export {
public:
    Export(const Scene& scene, Output& output)
        : scene_(scene), writer_(output), palette_(scene.materials) {
        const auto& nodes = scene.nodes;
        children_ =
            group(nodes.size(), nodes.size(), [&](std::size_t i) { return nodes[i].parent; });
        parts_ = group(scene.parts.size(), nodes.size(),
                       [&](std::size_t i) { return scene.parts[i].node; });
    }

    Status run();

private:
    void write_header();
    void write_tree();
    void begin_group(std::string_view name, const glm::dvec3& position, std::uint32_t material);
    void end_group();
    void write_node(std::uint32_t node);
    void write_part(const Part& part);
    void begin_part(const Part& part, const Box3& local, std::uint32_t kind);
    void write_shape(const Part& part);
    void write_mesh(const Part& part);
    template <class Vector>
    void write_facets(std::span<const Vector> positions, std::span<const Vector> normals,
                      std::span<const std::uint32_t> indices, const Part& part);
    void write_colours();

    const Scene& scene_;
    RvmWriter writer_;
    Palette palette_;
    Grouping children_;
    Grouping parts_;
};

void Export::write_header() {
    writer_.begin("HEAD");
    writer_.put_string("Quartic");
    writer_.put_string("");  // note
    writer_.put_string("");  // date: the same scene gives the same bytes
    writer_.put_string("");  // user
    writer_.put_string("Unicode UTF-8");
    writer_.end();
    writer_.begin("MODL");
    writer_.put_string("");
    writer_.put_string(scene_.title);
    writer_.end();
}

void Export::begin_group(std::string_view name, const glm::dvec3& position,
                         std::uint32_t material) {
    const bool has_material = material < scene_.materials.size();
    writer_.begin("CNTB");
    writer_.put_string(name);
    writer_.put_vector(glm::vec3(rvm_local_per_metre * position));
    writer_.put_word(has_material ? palette_.index(material) : 1);
    writer_.put_bytes(has_material ? palette_.transparency(material) : std::uint8_t{0}, 0, 0, 0);
    writer_.end();
}

void Export::end_group() {
    writer_.begin("CNTE");
    writer_.end();
}

// The parts of a node's first material, then a group for each run of another one.
void Export::write_node(std::uint32_t node) {
    const auto parts = parts_.of(node);
    const std::uint32_t own = parts.empty() ? no_index : scene_.parts[parts[0]].material;
    begin_group(scene_.strings[scene_.nodes[node].name], scene_.nodes[node].position, own);
    std::uint32_t open = own;
    for (const std::uint32_t index : parts) {
        const Part& part = scene_.parts[index];
        if (part.material != open) {
            if (open != own) {
                end_group();
            }
            if (part.material != own) {
                const bool named = part.material < scene_.materials.size();
                begin_group(named ? scene_.materials[part.material].name : "",
                            scene_.nodes[node].position, part.material);
            }
            open = part.material;
        }
        write_part(part);
    }
    if (open != own) {
        end_group();
    }
}

// Depth first without recursion: a stack of (node, next child).
void Export::write_tree() {
    std::vector<std::pair<std::uint32_t, std::size_t>> path;
    for (const std::uint32_t root : children_.of(scene_.nodes.size())) {
        write_node(root);
        path.emplace_back(root, 0);
        while (!path.empty()) {
            const auto children = children_.of(path.back().first);
            const std::size_t next = path.back().second++;
            if (next == children.size()) {
                end_group();
                path.pop_back();
            } else {
                write_node(children[next]);
                path.emplace_back(children[next], 0);
            }
        }
    }
}

void Export::begin_part(const Part& part, const Box3& local, std::uint32_t kind) {
    const bool volume = part.layer == Layer::obstruction || part.layer == Layer::insulation;
    writer_.begin(!volume ? "PRIM" : (part.layer == Layer::obstruction ? "OBST" : "INSU"));
    writer_.put_word(kind);
    if (volume) {
        const bool known = part.material < scene_.materials.size();
        writer_.put_bytes(known ? palette_.transparency(part.material) : std::uint8_t{0}, 0, 0, 0);
    }
    const glm::dmat3 axes = glm::mat3_cast(part.placement.rotation);
    for (int column = 0; column < 3; ++column) {
        writer_.put_vector(glm::vec3(axes[column] / rvm_local_per_metre));
    }
    writer_.put_vector(glm::vec3(part.placement.position));
    writer_.put_vector(glm::vec3(rvm_local_per_metre * local.low));
    writer_.put_vector(glm::vec3(rvm_local_per_metre * local.high));
}

void Export::write_shape(const Part& part) {
    visit_shape(scene_.shapes, part.type, part.shape, [&](const auto& shape) {
        using Shape = std::decay_t<decltype(shape)>;
        if constexpr (Implicit<Shape>) {
            const Triangles triangles = tessellate(shape, rvm_sagitta(shape));
            write_facets<glm::dvec3>(triangles.positions, triangles.normals, triangles.indices,
                                     part);
            return;
        }
        RvmRecordOfShape record = rvm_record(shape);
        if constexpr (std::is_same_v<Shape, f64::Cylinder>) {
            record = part.layer == Layer::line ? rvm_line_record(shape) : record;
        }
        const f64::Bounds bounds = f64().bounds(shape);
        begin_part(part, {bounds.low, bounds.high}, record.kind);
        for (std::size_t i = 0; i < record.count; ++i) {
            writer_.put_float(static_cast<float>(record.values[i]));
        }
        writer_.end();
    });
}

// Every triangle is a polygon of one contour.
template <class Vector>
void Export::write_facets(std::span<const Vector> positions, std::span<const Vector> normals,
                          std::span<const std::uint32_t> indices, const Part& part) {
    Box3 box;
    for (const Vector& position : positions) {
        box.low = glm::min(box.low, glm::dvec3(position));
        box.high = glm::max(box.high, glm::dvec3(position));
    }
    if (indices.empty()) {
        return;
    }
    begin_part(part, box, rvm_facet_group_kind);
    writer_.put_word(static_cast<std::uint32_t>(indices.size() / 3));
    for (std::size_t i = 0; i < indices.size(); ++i) {
        if (i % 3 == 0) {
            writer_.put_word(1);
            writer_.put_word(3);
        }
        const std::uint32_t index = indices[i];
        writer_.put_vector(glm::vec3(rvm_local_per_metre * glm::dvec3(positions[index])));
        writer_.put_vector(glm::vec3(normals[index]));
    }
    writer_.end();
}

void Export::write_mesh(const Part& part) {
    const Mesh& mesh = scene_.meshes[part.shape];
    write_facets<glm::vec3>(mesh.positions, mesh.normals, mesh.indices, part);
}

void Export::write_part(const Part& part) {
    part.type == ShapeType::mesh ? write_mesh(part) : write_shape(part);
}

void Export::write_colours() {
    std::uint32_t number = 0;
    for (const std::uint32_t rgb : palette_.colours()) {
        writer_.begin("COLR");
        writer_.put_word(++number);
        writer_.put_bytes(static_cast<std::uint8_t>(rgb >> 16),
                          static_cast<std::uint8_t>((rgb >> 8) & 0xff),
                          static_cast<std::uint8_t>(rgb & 0xff), 0);
        writer_.end();
    }
}

Status Export::run() {
    write_header();
    write_tree();
    write_colours();
    writer_.begin("END:");
    writer_.end();
    if (writer_.overflowed()) {
        return Error{ErrorKind::bad_data, "",
                     "an RVM file holds at most 4 GiB, as its offsets have 32 bits, and this model "
                     "needs more; "
                     "save parts of it, or another format"};
    }
    writer_.finish();
    return Done{};
}

}  // namespace

void remark_rvm(const Scene& scene, Findings& findings) {
    const auto is_implicit = [](const Part& part) {
        return std::ranges::any_of(shape_table(), [&](const ShapeRow& row) {
            return row.type == part.type && row.implicit;
        });
    };
    const auto count = std::ranges::count_if(scene.parts, is_implicit);
    if (count > 0) {
        findings.add(Severity::warning, "RVM",
                     "RVM has no surfaces given by an equation: written as triangles",
                     static_cast<std::uint64_t>(count));
    }
}

Status export_rvm(const Scene& scene, Output& output) {
    return Export(scene, output).run();
}

}  // namespace quartic
