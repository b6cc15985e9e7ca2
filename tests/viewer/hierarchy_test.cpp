// The tree's rows: order, unfolding, revealing, searching, and depth without recursion.
#include "viewer/hierarchy.h"

#include <gtest/gtest.h>

namespace quartic::viewer {
namespace {

std::uint32_t add_node(Scene& scene, std::string_view name, std::uint32_t parent) {
    scene.nodes.push_back({.name = scene.strings.add(name), .parent = parent});
    return static_cast<std::uint32_t>(scene.nodes.size() - 1);
}

// SITE { ZONE-A { PIPE-1 (part 0), PIPE-2 (part 2) }, ZONE-B (part 1) }
Scene sample_scene() {
    Scene scene;
    const std::uint32_t site = add_node(scene, "SITE", no_index);
    const std::uint32_t zone_a = add_node(scene, "ZONE-A", site);
    const std::uint32_t pipe_1 = add_node(scene, "PIPE-1", zone_a);
    const std::uint32_t zone_b = add_node(scene, "ZONE-B", site);
    const std::uint32_t pipe_2 = add_node(scene, "PIPE-2", zone_a);
    for (const std::uint32_t node : {pipe_1, zone_b, pipe_2}) {
        Part part;
        part.node = node;
        part.placement.position = {static_cast<double>(node), 0.0, 0.0};
        add_part(scene, f64::Sphere{0.5, 0.0, 0.0, 0.0}, part);
    }
    return scene;
}

std::string names_of(const Scene& scene, const TreeRows& rows) {
    std::string text;
    for (const TreeRow& row : rows.rows()) {
        text += std::string(row.depth, '.');
        text += row.is_part ? "part" + std::to_string(row.id)
                            : std::string(scene.strings[scene.nodes[row.id].name]);
        text += ' ';
    }
    return text;
}

TEST(TreeRows, only_root_is_unfolded_at_first) {
    const Scene scene = sample_scene();
    const Hierarchy hierarchy(scene);
    EXPECT_EQ(names_of(scene, TreeRows(scene, hierarchy)), "SITE .ZONE-A .ZONE-B ");
}

TEST(TreeRows, toggled_node_shows_its_children_in_order_and_hides_them_again) {
    const Scene scene = sample_scene();
    const Hierarchy hierarchy(scene);
    TreeRows rows(scene, hierarchy);
    rows.toggle(hierarchy, 1);
    EXPECT_EQ(names_of(scene, rows), "SITE .ZONE-A ..PIPE-1 ..PIPE-2 .ZONE-B ");
    rows.toggle(hierarchy, 1);
    EXPECT_EQ(names_of(scene, rows), "SITE .ZONE-A .ZONE-B ");
}

TEST(TreeRows, revealed_part_has_a_row) {
    const Scene scene = sample_scene();
    const Hierarchy hierarchy(scene);
    TreeRows rows(scene, hierarchy);
    rows.reveal(scene, hierarchy, 4, true);
    EXPECT_EQ(names_of(scene, rows), "SITE .ZONE-A ..PIPE-1 ..PIPE-2 ...part2 .ZONE-B ");
}

TEST(TreeRows, scene_without_nodes_has_no_rows) {
    const Scene scene;
    const Hierarchy hierarchy(scene);
    EXPECT_TRUE(TreeRows(scene, hierarchy).rows().empty());
}

TEST(TreeRows, hundred_thousand_levels_do_not_exhaust_the_stack) {
    Scene scene;
    std::uint32_t parent = no_index;
    for (int i = 0; i < 100000; ++i) {
        parent = add_node(scene, "LEVEL", parent);
    }
    const Hierarchy hierarchy(scene);
    EXPECT_EQ(TreeRows(scene, hierarchy).rows().size(), 100000u);
    EXPECT_TRUE(boxes_of_node(scene, hierarchy, 0).empty());
    EXPECT_TRUE(around({}).empty());
}

TEST(FindNodes, letters_of_either_case_match_anywhere_in_the_name) {
    const Scene scene = sample_scene();
    EXPECT_EQ(find_nodes(scene, "pipe"), (std::vector<std::uint32_t>{2, 4}));
    EXPECT_EQ(find_nodes(scene, "-B"), (std::vector<std::uint32_t>{3}));
    EXPECT_TRUE(find_nodes(scene, "valve").empty());
}

TEST(BoxesOfNode, parts_of_all_nodes_below_are_in) {
    const Scene scene = sample_scene();
    const Hierarchy hierarchy(scene);
    const Box3 box = around(boxes_of_node(scene, hierarchy, 1));
    EXPECT_DOUBLE_EQ(box.low.x, 1.5);
    EXPECT_DOUBLE_EQ(box.high.x, 4.5);
}

}  // namespace
}  // namespace quartic::viewer
