// The tree without recursion: files may nest as deep as they like.
#include "viewer/hierarchy.h"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <string>

namespace quartic::viewer {

std::span<const std::uint32_t> Hierarchy::list_of(const Lists& lists, std::size_t i) {
    if (i + 1 >= lists.starts.size()) {
        return {};
    }
    return std::span(lists.items).subspan(lists.starts[i], lists.starts[i + 1] - lists.starts[i]);
}

// Sorts 0, 1, ... by their owners, keeping their order; an owner beyond the count owns nothing.
Hierarchy::Lists Hierarchy::make_lists(std::span<const std::uint32_t> owners, std::size_t count) {
    Lists lists;
    lists.starts.assign(count + 1, 0);
    for (const std::uint32_t owner : owners) {
        if (owner < count) {
            ++lists.starts[owner + 1];
        }
    }
    for (std::size_t i = 0; i < count; ++i) {
        lists.starts[i + 1] += lists.starts[i];
    }
    lists.items.resize(lists.starts[count]);
    std::vector<std::uint32_t> next(lists.starts.begin(), std::prev(lists.starts.end()));
    for (std::uint32_t i = 0; i < owners.size(); ++i) {
        if (owners[i] < count) {
            lists.items[next[owners[i]]++] = i;
        }
    }
    return lists;
}

Hierarchy::Hierarchy(const Scene& scene) {
    std::vector<std::uint32_t> owners;
    owners.reserve(std::max(scene.nodes.size(), scene.parts.size()));
    for (const Node& node : scene.nodes) {
        owners.push_back(node.parent == no_index ? 0 : node.parent + 1);
    }
    children_ = make_lists(owners, scene.nodes.size() + 1);
    owners.clear();
    for (const Part& part : scene.parts) {
        owners.push_back(part.node);
    }
    parts_ = make_lists(owners, scene.nodes.size());
}

TreeRows::TreeRows(const Scene& scene, const Hierarchy& hierarchy)
    : unfolded_(scene.nodes.size(), false) {
    std::span<const std::uint32_t> level = hierarchy.roots();
    while (level.size() == 1) {
        unfolded_[level.front()] = true;
        level = hierarchy.children(level.front());
    }
    rebuild(hierarchy);
}

void TreeRows::toggle(const Hierarchy& hierarchy, std::uint32_t node) {
    unfolded_[node] = !unfolded_[node];
    rebuild(hierarchy);
}

void TreeRows::reveal(const Scene& scene, const Hierarchy& hierarchy, std::uint32_t node,
                      bool with_parts) {
    bool changed = with_parts && !unfolded_[node];
    unfolded_[node] = unfolded_[node] || with_parts;
    for (std::uint32_t at = scene.nodes[node].parent; at != no_index; at = scene.nodes[at].parent) {
        changed = changed || !unfolded_[at];
        unfolded_[at] = true;
    }
    if (changed) {
        rebuild(hierarchy);
    }
}

void TreeRows::rebuild(const Hierarchy& hierarchy) {
    rows_.clear();
    std::vector<TreeRow> waiting;  // the next row is the last one
    const auto push_nodes = [&](std::span<const std::uint32_t> nodes, std::uint32_t depth) {
        for (auto node = nodes.rbegin(); node != nodes.rend(); ++node) {
            waiting.push_back({*node, depth, false});
        }
    };
    push_nodes(hierarchy.roots(), 0);
    while (!waiting.empty()) {
        const TreeRow row = waiting.back();
        waiting.pop_back();
        rows_.push_back(row);
        if (!row.is_part && unfolded_[row.id]) {
            for (const std::uint32_t part : hierarchy.parts(row.id)) {
                rows_.push_back({part, row.depth + 1, true});
            }
            push_nodes(hierarchy.children(row.id), row.depth + 1);
        }
    }
}

std::vector<std::uint32_t> find_nodes(const Scene& scene, std::string_view text) {
    const auto lower = [](char c) {
        return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    };
    std::string wanted;
    std::transform(text.begin(), text.end(), std::back_inserter(wanted), lower);
    std::vector<std::uint32_t> found;
    for (std::uint32_t i = 0; i < scene.nodes.size(); ++i) {
        const std::string_view name = scene.strings[scene.nodes[i].name];
        const auto at = std::search(name.begin(), name.end(), wanted.begin(), wanted.end(),
                                    [&](char a, char b) { return lower(a) == b; });
        if (at != name.end() || wanted.empty()) {
            found.push_back(i);
        }
    }
    return found;
}

std::vector<Box3> boxes_of_node(const Scene& scene, const Hierarchy& hierarchy,
                                std::uint32_t node) {
    std::vector<Box3> boxes;
    std::vector<std::uint32_t> waiting{node};
    while (!waiting.empty()) {
        const std::uint32_t at = waiting.back();
        waiting.pop_back();
        for (const std::uint32_t part : hierarchy.parts(at)) {
            boxes.push_back(world_bounds(scene, scene.parts[part]));
        }
        const std::span<const std::uint32_t> below = hierarchy.children(at);
        waiting.insert(waiting.end(), below.begin(), below.end());
    }
    return boxes;
}

Box3 around(std::span<const Box3> boxes) {
    Box3 all;
    for (const Box3& box : boxes) {
        all.low = glm::min(all.low, box.low);
        all.high = glm::max(all.high, box.high);
    }
    return all;
}

}  // namespace quartic::viewer
