// Keeps the open group by its parent link: no stack, any depth.
#include "importers/rvm_groups.h"

namespace quartic {

void RvmGroups::begin(std::string_view name, const glm::dvec3& position_mm, std::uint32_t colour,
                      std::optional<std::uint8_t> transparency) {
    const std::uint8_t inherited =
        current_ == no_index ? std::uint8_t{0} : looks_[current_].transparency;
    Node node;
    node.name = scene_.strings.add(name);
    node.parent = current_;
    node.position = 0.001 * position_mm;
    current_ = static_cast<std::uint32_t>(scene_.nodes.size());
    scene_.nodes.push_back(node);
    looks_.push_back({colour, transparency.value_or(inherited)});
}

bool RvmGroups::end() {
    if (current_ == no_index) {
        return false;
    }
    current_ = scene_.nodes[current_].parent;
    return true;
}

std::uint32_t RvmGroups::current() {
    if (current_ != no_index) {
        return current_;
    }
    if (outside_ == no_index) {
        begin("", glm::dvec3(0.0), RvmLook().colour, std::nullopt);
        outside_ = current_;
        current_ = no_index;
    }
    return outside_;
}

}  // namespace quartic
