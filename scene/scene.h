// The document: what a model contains, in double and in metres and radians, z up; nothing of how it
// is drawn.
#pragma once

#include "diagnostics/findings.h"
#include "primitives/shape.h"
#include "scene/strings.h"

#include <glm/gtc/quaternion.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace quartic {

// A rigid motion: world = position + rotation * local. The rotation is a unit quaternion.
struct Placement {
    glm::dvec3 position{0.0};
    glm::dquat rotation{1.0, 0.0, 0.0, 0.0};
};

constexpr std::uint32_t no_index = 0xffffffff;

// An element of the model's hierarchy (an RVM group, an assembly). Parents stand before their
// children.
struct Node {
    StringPool::Id name = 0;
    std::uint32_t parent = no_index;
    std::uint32_t first_attribute = 0;
    std::uint32_t attribute_count = 0;
    glm::dvec3 position{0.0};  // the element's reference point in the world, as the file gives it
};

struct Attribute {
    StringPool::Id key = 0;
    StringPool::Id value = 0;
};

struct Material {
    std::string name;
    glm::vec4 colour{0.7f, 0.7f, 0.7f, 1.0f};  // linear; alpha 1 is opaque
    int solver = 0;                            // an id of solvers/solver_table.h; 0: the default
};

// Which of the model's layers a part belongs to; lines are hidden by default.
enum class Layer : std::uint8_t { normal, obstruction, insulation, line };
constexpr std::size_t layer_count = 4;

// Triangles in the local frame of the parts that place them, in metres.
struct Mesh {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;  // one for each position, unit
    std::vector<std::uint32_t> indices;
};

// One placed shape or mesh. Several parts may share one shape: then they are instances of it.
struct Part {
    Placement placement;
    std::uint32_t node = 0;
    std::uint32_t material = 0;
    std::uint32_t shape = 0;  // index in the array of its type: shapes.cylinder, ..., or meshes
    ShapeType type = ShapeType::mesh;
    std::uint8_t kind = 0;  // index in kinds: what the source called it
    Layer layer = Layer::normal;
    std::uint8_t open_ends = 0;    // bit i: the cap of end i is hidden by a neighbour and not drawn
    std::uint8_t smooth_ends = 0;  // bit i: the wall goes on smoothly into the neighbour at end i
};

// What an importer made of the elements of one kind.
struct Outcome {
    std::string kind;
    std::string became;  // "analytic", "triangles", "tessellated" or "skipped"
    std::string reason;  // empty where nothing needs to be said
    std::uint64_t count = 0;
};

struct Scene {
    std::vector<Node> nodes;
    std::vector<Attribute> attributes;
    std::vector<Material> materials;
    ShapeStore shapes;
    std::vector<Mesh> meshes;
    std::vector<Part> parts;  // a part's index is its id
    StringPool strings;

    std::vector<std::string> kinds;          // names of the source's kinds, e.g. "cylinder", "line"
    std::vector<std::uint64_t> kind_counts;  // how many of each the source held, drawn or not
    std::vector<Outcome> outcomes;
    Findings findings;
    double max_deviation_m = 0.0;  // of triangles from the surfaces they stand for
    std::string unit = "m";        // of the source; the scene itself is in metres
    std::string up_axis = "z";
    std::string title;  // what the source calls itself
};

// Places a new shape; returns the part's index. The shape must have no fault (find_fault).
template <class Shape>
std::uint32_t add_part(Scene& scene, const Shape& shape, Part part) {
    std::vector<Shape>& array = array_of<Shape>(scene.shapes);
    part.type = type_of<Shape>;
    part.shape = static_cast<std::uint32_t>(array.size());
    array.push_back(shape);
    scene.parts.push_back(part);
    return static_cast<std::uint32_t>(scene.parts.size() - 1);
}

std::uint32_t add_mesh_part(Scene& scene, Mesh mesh, Part part);

struct Box3 {
    glm::dvec3 low{1e300};
    glm::dvec3 high{-1e300};
    bool empty() const { return low.x > high.x; }
};

// The tight world box of a part's rotated local box, and of all visible parts.
Box3 world_bounds(const Scene& scene, const Part& part);
Box3 world_bounds(const Scene& scene, const std::array<bool, layer_count>& layers);

// The boxes of all visible parts.
std::vector<Box3> part_boxes(const Scene& scene, const std::array<bool, layer_count>& layers);

// The solver that a part is drawn with: the one for everything, or, where that is 0, its
// material's; the default where that does not work on its shape. of_materials: what stands for the
// materials' own, if not empty.
int solver_of(const Scene& scene, const Part& part, int everywhere,
              std::span<const int> of_materials = {});

// Joins names from the root: "/SITE/ZONE/PIPE-1".
std::string path_of(const Scene& scene, std::uint32_t node);

}  // namespace quartic
