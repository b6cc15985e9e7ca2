// Walks through the tree of objects, and places surfaces in cubes.
#include "importers/pov_scene.h"

#include "scene/algebraic_surface.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

namespace quartic {
namespace {

constexpr double rounding = 1e-12;

// Whatever is within a group that has one child, and is no group.
const PovObject& bare(const PovObject& object) {
    const PovObject* inner = &object;
    while (inner->kind == PovKind::group && inner->children.size() == 1) {
        inner = inner->children[0].object.get();
    }
    return *inner;
}

bool is_identity(const glm::dmat4& matrix) {
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row) {
            if (std::abs(matrix[column][row] - (column == row ? 1.0 : 0.0)) > rounding) {
                return false;
            }
        }
    }
    return true;
}

bool is_finite(const glm::dmat4& matrix) {
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row) {
            if (!std::isfinite(matrix[column][row])) {
                return false;
            }
        }
    }
    return true;
}

bool is_bounded(const Box3& box) {
    const glm::dvec3 lengths = box.high - box.low;
    return std::isfinite(lengths.x) && std::isfinite(lengths.y) && std::isfinite(lengths.z);
}

// Floats hold no more than 1e38: large and small coefficients are scaled.
Polynomial3 for_floats(const Polynomial3& polynomial) {
    const double largest = polynomial.largest_term();
    return largest > 1e6 || largest < 1e-6 ? (1.0 / largest) * polynomial : polynomial;
}

}  // namespace

void PovSceneBuilder::add(const PovPlaced& object) {
    visit(*object.object, Around{});
}

void PovSceneBuilder::tally(const PovObject& object, std::string_view became,
                            std::string_view reason, Severity severity) {
    const auto same = std::find_if(counts_.begin(), counts_.end(), [&](const Count& count) {
        return count.kind == object.word && count.became == became && count.reason == reason;
    });
    if (same != counts_.end()) {
        ++same->count;
    } else {
        counts_.push_back({object.word, became, reason, 1});
    }
    if (!reason.empty()) {
        scene_.findings.add(severity, "line " + std::to_string(object.line),
                            std::string(object.word) + ": " + std::string(reason));
    }
}

void PovSceneBuilder::visit(const PovObject& object, const Around& around) {
    if (visits_left_ == 0) {
        scene_.findings.add(Severity::loss, "line " + std::to_string(object.line),
                            "objects beyond the most that a file of this size may place");
        return;
    }
    --visits_left_;
    Around here = around;
    here.matrix = around.matrix * object.matrix;
    here.colour = object.colour ? object.colour : around.colour;
    here.name = around.name.empty() ? object.name : around.name;
    for (const PovPlaced& clip : object.clips) {
        here.clips.push_back({clip.object, around.matrix * clip.matrix});
    }
    for (const PovPlaced& bound : object.bounds) {
        here.bounds.push_back({bound.object, around.matrix * bound.matrix});
    }
    if (!is_finite(here.matrix)) {
        tally(object, "skipped", "transformations beyond all bounds", Severity::loss);
    } else if (object.kind == PovKind::group) {
        visit_children(object, here);
    } else if (object.kind == PovKind::intersection) {
        intersection(object, here);
    } else {
        draw(object, here);
    }
}

void PovSceneBuilder::visit_children(const PovObject& object, const Around& here) {
    for (const PovPlaced& child : object.children) {
        visit(*child.object, here);
    }
}

// A surface in limits; other intersections are solids that no shape of ours is.
void PovSceneBuilder::intersection(const PovObject& object, const Around& here) {
    if (torus_arc(object, here)) {
        return;
    }
    const auto is_surface = [](const PovPlaced& child) {
        return bare(*child.object).kind == PovKind::algebraic;
    };
    if (std::none_of(object.children.begin(), object.children.end(), is_surface)) {
        tally(object, "skipped", "solids cut by solids are not drawn", Severity::loss);
        return;
    }
    Around inside = here;
    for (const PovPlaced& child : object.children) {
        if (!is_surface(child)) {
            inside.clips.push_back({child.object, here.matrix * child.matrix});
        }
    }
    for (const PovPlaced& child : object.children) {
        if (is_surface(child)) {
            visit(*child.object, inside);
        }
    }
}

// The limits' box; without any, a box around the surface.
PovDomain PovSceneBuilder::surface_domain(const PovObject& object, const Around& here,
                                          bool& exact) {
    const glm::dmat3 own = orthonormal(glm::dmat3(pov_to_world() * here.matrix));
    PovDomain domain = domain_of(here.clips, own);
    exact = is_bounded(domain.box);
    if (exact) {
        return domain;
    }
    std::vector<PovPlaced> limits = here.clips;
    limits.insert(limits.end(), here.bounds.begin(), here.bounds.end());
    const PovExtent extent = extent_for(object.polynomial);
    if (extent.closed || !is_bounded(domain_of(limits, own).box)) {
        const auto around = std::make_shared<PovObject>();
        around->kind = PovKind::box;
        around->numbers = {extent.box.low.x,  extent.box.low.y,  extent.box.low.z,
                           extent.box.high.x, extent.box.high.y, extent.box.high.z};
        limits.push_back({around, here.matrix});
        domain = domain_of(limits, own);
        domain.remark = extent.closed ? std::string_view()
                                      : "no limits: clipped by a cube of 10 units of its own";
        return domain;
    }
    domain = domain_of(limits, own);
    domain.remark = {};  // the box only has to be large enough
    return domain;
}

// Equal polynomials are looked at once, and not too many of them.
PovExtent PovSceneBuilder::extent_for(const Polynomial3& polynomial) {
    constexpr std::size_t most = 200;
    const auto known = extents_.find(polynomial.terms());
    if (known != extents_.end()) {
        return known->second;
    }
    if (extents_.size() >= most) {
        return {};
    }
    return extents_[polynomial.terms()] = extent_of(polynomial);
}

void PovSceneBuilder::algebraic(const PovObject& object, const Around& here) {
    bool exact = false;
    const PovDomain domain = surface_domain(object, here, exact);
    const glm::dvec3 lengths = domain.box.high - domain.box.low;
    const double determinant = glm::determinant(glm::dmat3(here.matrix));
    if (!(std::min({lengths.x, lengths.y, lengths.z}) > 0.0)) {
        tally(object, "skipped", "limits that leave nothing", Severity::loss);
    } else if (!(std::abs(determinant) > 1e-200) || !is_bounded(domain.box)) {
        tally(object, "skipped", "a transformation that flattens it", Severity::loss);
    } else {
        surface(object, here, domain, exact ? cubes_of(domain.box) : cube_around(domain.box));
    }
}

void PovSceneBuilder::surface(const PovObject& object, const Around& here, const PovDomain& domain,
                              const PovCubes& cubes) {
    const glm::dmat4 to_own = glm::inverse(pov_to_world() * here.matrix);
    std::string_view reason = domain.remark;
    for (const glm::dvec3& centre : cubes.centres) {
        Part part = part_of(object, here);
        part.placement.position = domain.axes * centre;
        part.placement.rotation = glm::normalize(glm::quat_cast(domain.axes));
        glm::dmat4 cube(cubes.half_size * domain.axes);
        cube[3] = glm::dvec4(part.placement.position, 1.0);
        const glm::dmat4 map = to_own * cube;
        const Polynomial3 polynomial =
            is_identity(map) ? object.polynomial : object.polynomial.of(glm::dmat4x3(map));
        const Added added = add_surface(scene_, for_floats(polynomial), cubes.half_size, part);
        if (!added.drawn) {
            tally(object, "skipped", added.reason, Severity::loss);
            return;
        }
    }
    const bool larger = !cubes.exact && domain.remark.empty() && !here.clips.empty();
    reason = larger ? "a long limit: clipped by the cube around it" : reason;
    tally(object, "analytic", reason, Severity::note);
}

std::uint32_t PovSceneBuilder::material_of(const std::optional<PovValue>& colour) {
    std::array<float, 4> rgba{0.7f, 0.7f, 0.7f, 1.0f};
    if (colour) {
        for (std::size_t i = 0; i < 3; ++i) {
            rgba[i] = static_cast<float>(std::clamp(colour->of[i], 0.0, 1.0));
        }
        rgba[3] = static_cast<float>(1.0 - std::clamp(colour->of[3] + colour->of[4], 0.0, 1.0));
    }
    for (float& channel : rgba) {
        channel = std::isfinite(channel) ? channel : 0.0f;
    }
    const auto next = static_cast<std::uint32_t>(scene_.materials.size());
    const auto [entry, added] = materials_.try_emplace(rgba, next);
    if (added) {
        std::array<char, 64> name{};
        std::snprintf(name.data(), name.size(), "rgbt %.3g %.3g %.3g %.3g", double(rgba[0]),
                      double(rgba[1]), double(rgba[2]), 1.0 - double(rgba[3]));
        scene_.materials.push_back({name.data(), {rgba[0], rgba[1], rgba[2], rgba[3]}, 0});
    }
    return entry->second;
}

// A node of its own for each object.
Part PovSceneBuilder::part_of(const PovObject& object, const Around& here) {
    if (scene_.nodes.empty()) {
        Node root;
        root.name = scene_.strings.add(scene_.title);
        scene_.nodes.push_back(root);
    }
    Node node;
    node.name = scene_.strings.add(here.name.empty() ? object.word : here.name);
    node.parent = 0;
    node.position = glm::dvec3((pov_to_world() * here.matrix)[3]);
    Part part;
    part.node = static_cast<std::uint32_t>(scene_.nodes.size());
    scene_.nodes.push_back(node);
    part.material = material_of(here.colour);
    auto kind = std::find(scene_.kinds.begin(), scene_.kinds.end(), object.word);
    if (kind == scene_.kinds.end()) {
        scene_.kinds.emplace_back(object.word);
        kind = scene_.kinds.end() - 1;
    }
    part.kind = static_cast<std::uint8_t>(kind - scene_.kinds.begin());
    part.placement.position = node.position;
    return part;
}

void PovSceneBuilder::finish() {
    for (const Count& count : counts_) {
        if (std::find(scene_.kinds.begin(), scene_.kinds.end(), count.kind) == scene_.kinds.end()) {
            scene_.kinds.emplace_back(count.kind);
        }
    }
    scene_.kind_counts.assign(scene_.kinds.size(), 0);
    for (const Count& count : counts_) {
        const auto kind = std::find(scene_.kinds.begin(), scene_.kinds.end(), count.kind);
        scene_.kind_counts[static_cast<std::size_t>(kind - scene_.kinds.begin())] += count.count;
        scene_.outcomes.push_back({std::string(count.kind), std::string(count.became),
                                   std::string(count.reason), count.count});
    }
}

}  // namespace quartic
