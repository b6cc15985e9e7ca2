// Finds nodes by parent and name; equal names come one after another.
#pragma once

#include "scene/scene.h"

#include <cstdint>
#include <string_view>
#include <vector>

namespace quartic {

class NodeNames {
public:
    explicit NodeNames(const Scene& scene);

    // The next child of that name, or no_index. Names repeat: equal ones come in order, the last
    // one stays.
    std::uint32_t take(std::uint32_t parent, std::string_view name);

private:
    struct Slot {
        std::uint64_t hash = 0;
        std::uint32_t node = no_index;
    };
    bool matches(const Slot& slot, std::uint64_t hash, std::uint32_t parent,
                 std::string_view name) const;

    const Scene& scene_;
    std::vector<Slot> slots_;               // open addressing; the size is a power of two
    std::vector<std::uint32_t> following_;  // the next node of the same parent and name
};

}  // namespace quartic
