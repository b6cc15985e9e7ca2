// The tree of groups (CNTB ... CNTE) while an RVM file is read, with the colours that its
// primitives take from it.
#pragma once

#include "scene/scene.h"

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace quartic {

struct RvmLook {
    std::uint32_t colour = 1;       // index of a COLR chunk or of the default palette
    std::uint8_t transparency = 0;  // per cent
};

class RvmGroups {
public:
    explicit RvmGroups(Scene& scene) : scene_(scene) {}

    // The position is in millimetres, as in the file. Without its own transparency a group has its
    // parent's.
    void begin(std::string_view name, const glm::dvec3& position_mm, std::uint32_t colour,
               std::optional<std::uint8_t> transparency);

    // False where no group is open.
    bool end();

    // The open group's node. Primitives outside of any group get a nameless one.
    std::uint32_t current();

    bool is_open() const { return current_ != no_index; }
    const RvmLook& look(std::uint32_t node) const { return looks_[node]; }

private:
    Scene& scene_;
    std::vector<RvmLook> looks_;  // of each node
    std::uint32_t current_ = no_index;
    std::uint32_t outside_ = no_index;
};

}  // namespace quartic
