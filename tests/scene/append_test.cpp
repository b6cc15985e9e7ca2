// Scenes that become one keep their parts, names and counts.
#include "scene/append.h"
#include "scene/add_shape.h"

#include <gtest/gtest.h>

namespace quartic {
namespace {

// A root with one child, a part in the child, one attribute, one material.
Scene sample(const std::string& name, const std::string& kind) {
    Scene scene;
    scene.title = name;
    scene.kinds = {"box", kind};
    scene.kind_counts = {0, 1};
    scene.materials.push_back({name + " paint", {0.1f, 0.2f, 0.3f, 1.0f}, 0});
    Node root;
    root.name = scene.strings.add(name);
    Node child;
    child.name = scene.strings.add(name + " child");
    child.parent = 0;
    child.attribute_count = 1;
    scene.nodes = {root, child};
    scene.attributes.push_back({scene.strings.add("Tag"), scene.strings.add(name + "-1")});
    Part part;
    part.node = 1;
    part.kind = 1;
    add_shape(scene, f64::Cylinder{0.1, 1.0, 0.0, 0.0}, part);
    scene.outcomes.push_back({kind, "analytic", "", 1});
    scene.findings.add(Severity::note, "here", "something");
    return scene;
}

TEST(Append, the_other_scene_follows_with_its_own_names_and_materials) {
    Scene scene = sample("first", "cylinder");
    append_scene(scene, sample("second", "pipe"));
    ASSERT_EQ(scene.parts.size(), 2u);
    const Part& part = scene.parts[1];
    EXPECT_EQ(path_of(scene, part.node), "/second/second child");
    EXPECT_EQ(scene.materials.at(part.material).name, "second paint");
    EXPECT_EQ(scene.kinds.at(part.kind), "pipe");
    EXPECT_EQ(part.shape, 1u);
    EXPECT_EQ(scene.shapes.cylinder.size(), 2u);
    const Node& node = scene.nodes[part.node];
    ASSERT_EQ(node.attribute_count, 1u);
    EXPECT_EQ(scene.strings[scene.attributes.at(node.first_attribute).value], "second-1");
    EXPECT_EQ(path_of(scene, scene.parts[0].node), "/first/first child");
    EXPECT_EQ(scene.title, "first + second");
}

TEST(Append, kinds_outcomes_and_findings_of_the_same_name_are_added) {
    Scene scene = sample("first", "cylinder");
    append_scene(scene, sample("second", "cylinder"));
    EXPECT_EQ(scene.kinds, (std::vector<std::string>{"box", "cylinder"}));
    EXPECT_EQ(scene.kind_counts, (std::vector<std::uint64_t>{0, 2}));
    ASSERT_EQ(scene.outcomes.size(), 1u);
    EXPECT_EQ(scene.outcomes[0].count, 2u);
    ASSERT_EQ(scene.findings.list().size(), 1u);
    EXPECT_EQ(scene.findings.list()[0].count, 2u);
}

TEST(Append, an_empty_scene_becomes_the_other) {
    Scene scene;
    append_scene(scene, sample("only", "cylinder"));
    EXPECT_EQ(scene.title, "only");
    EXPECT_EQ(path_of(scene, scene.parts.at(0).node), "/only/only child");
}

}  // namespace
}  // namespace quartic
