// Materials of RVM files: one for each colour index, transparency and layer that occurs.
#pragma once

#include "importers/rvm_groups.h"
#include "scene/scene.h"

#include <cstdint>
#include <unordered_map>
#include <vector>

namespace quartic {

// What COLR chunks say; other indices have the colour of the PDMS default palette, or one of their
// own.
class RvmColours {
public:
    void set(std::uint32_t index, std::uint8_t red, std::uint8_t green, std::uint8_t blue);

    // Linear, opaque.
    glm::vec3 linear(std::uint32_t index) const;

private:
    std::unordered_map<std::uint32_t, std::uint32_t> bytes_;  // index to 0xrrggbb
};

// Numbers materials in the order of their first use.
class RvmMaterials {
public:
    using Key = std::uint64_t;

    std::uint32_t number_of(const RvmLook& look, Layer layer);
    std::uint32_t number_of(Key key);
    const std::vector<Key>& keys() const { return keys_; }

    std::vector<Material> make(const RvmColours& colours) const;

private:
    std::vector<Key> keys_;
    std::unordered_map<Key, std::uint32_t> numbers_;
    Key last_key_ = ~Key{0};
    std::uint32_t last_number_ = 0;
};

}  // namespace quartic
