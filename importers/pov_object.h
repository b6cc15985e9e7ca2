// What POV-Ray's scene language says of one object: a tree without names, which may share branches.
#pragma once

#include "importers/pov_values.h"
#include "scene/polynomial3.h"
#include "scene/scene.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace quartic {

enum class PovKind : std::uint8_t {
    group,         // union, merge, object
    intersection,  // also difference, of which the first child counts
    algebraic,     // cubic, quartic, poly, quadric
    sphere,
    box,
    cylinder,
    cone,
    torus,
    disc,
    plane,
    mesh,
};

struct PovObject;

// An object within another one's frame.
struct PovPlaced {
    std::shared_ptr<const PovObject> object;
    glm::dmat4 matrix{1.0};
};

struct PovObject {
    PovKind kind = PovKind::group;
    std::string_view word;        // as the file calls the kind: a constant text
    std::vector<double> numbers;  // of the statement, in its order, vectors written out
    Polynomial3 polynomial;
    Mesh mesh;
    glm::dmat4 matrix{1.0};
    std::vector<PovPlaced> children;
    std::vector<PovPlaced> clips;
    std::vector<PovPlaced> bounds;
    std::optional<PovValue> colour;  // red, green, blue, filter, transmit
    bool open = false;
    bool inverse = false;
    std::string name;
    std::size_t line = 0;
    int depth = 1;            // of the tree
    std::uint64_t count = 1;  // of objects in it, each as often as it is placed; saturates

    // Puts a transformation after those that are there: it moves all that was said before.
    void transform(const glm::dmat4& next);
};

constexpr int pov_depth_max = 48;
constexpr std::uint64_t pov_count_max = std::uint64_t{1} << 40;

}  // namespace quartic
