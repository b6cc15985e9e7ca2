// The model's tree as rows of a list: what is unfolded, what a search finds; fit for a million
// nodes.
#pragma once

#include "scene/scene.h"

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace quartic::viewer {

// Children and parts of every node, in the order of the file.
class Hierarchy {
public:
    Hierarchy() = default;
    explicit Hierarchy(const Scene& scene);

    std::span<const std::uint32_t> roots() const { return list_of(children_, 0); }
    std::span<const std::uint32_t> children(std::uint32_t node) const {
        return list_of(children_, std::size_t{node} + 1);
    }
    std::span<const std::uint32_t> parts(std::uint32_t node) const { return list_of(parts_, node); }

private:
    // Many lists in one: list i is items[starts[i]] up to items[starts[i + 1]].
    struct Lists {
        std::vector<std::uint32_t> starts{0};
        std::vector<std::uint32_t> items;
    };
    static std::span<const std::uint32_t> list_of(const Lists& lists, std::size_t i);
    static Lists make_lists(std::span<const std::uint32_t> owners, std::size_t count);

    Lists children_;
    Lists parts_;
};

struct TreeRow {
    std::uint32_t id = 0;  // of the node, or of the part
    std::uint32_t depth = 0;
    bool is_part = false;
};

class TreeRows {
public:
    TreeRows() = default;
    // Roots are unfolded at first, down to the first node that has several children.
    TreeRows(const Scene& scene, const Hierarchy& hierarchy);

    const std::vector<TreeRow>& rows() const { return rows_; }
    bool is_unfolded(std::uint32_t node) const { return unfolded_[node]; }
    void toggle(const Hierarchy& hierarchy, std::uint32_t node);
    // Unfolds everything above a node, and the node too if its parts shall be seen.
    void reveal(const Scene& scene, const Hierarchy& hierarchy, std::uint32_t node,
                bool with_parts);

private:
    void rebuild(const Hierarchy& hierarchy);

    std::vector<bool> unfolded_;
    std::vector<TreeRow> rows_;
};

// Nodes whose names contain the text, letters of either case (ASCII) being equal.
std::vector<std::uint32_t> find_nodes(const Scene& scene, std::string_view text);

// The boxes of all parts of a node and of the nodes below it.
std::vector<Box3> boxes_of_node(const Scene& scene, const Hierarchy& hierarchy, std::uint32_t node);

// The box around boxes.
Box3 around(std::span<const Box3> boxes);

}  // namespace quartic::viewer
