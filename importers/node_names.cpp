// A hash table of (parent, name) with chains of equal entries.
#include "importers/node_names.h"

#include <bit>
#include <functional>

namespace quartic {
namespace {

std::uint64_t hash_of(std::uint32_t parent, std::string_view name) {
    return std::hash<std::string_view>()(name) ^ ((parent + std::uint64_t{1}) * 0x9e3779b97f4a7c15);
}

}  // namespace

NodeNames::NodeNames(const Scene& scene)
    : scene_(scene),
      slots_(std::bit_ceil(2 * scene.nodes.size() + 2)),
      following_(scene.nodes.size(), no_index) {
    // Backwards, so that a chain begins with its first node.
    for (std::size_t i = scene.nodes.size(); i-- > 0;) {
        const Node& node = scene.nodes[i];
        const std::string_view name = scene.strings[node.name];
        const std::uint64_t hash = hash_of(node.parent, name);
        std::size_t at = hash & (slots_.size() - 1);
        while (slots_[at].node != no_index && !matches(slots_[at], hash, node.parent, name)) {
            at = (at + 1) & (slots_.size() - 1);
        }
        following_[i] = slots_[at].node;
        slots_[at] = {hash, static_cast<std::uint32_t>(i)};
    }
}

bool NodeNames::matches(const Slot& slot, std::uint64_t hash, std::uint32_t parent,
                        std::string_view name) const {
    return slot.hash == hash && scene_.nodes[slot.node].parent == parent &&
           scene_.strings[scene_.nodes[slot.node].name] == name;
}

std::uint32_t NodeNames::take(std::uint32_t parent, std::string_view name) {
    const std::uint64_t hash = hash_of(parent, name);
    std::size_t at = hash & (slots_.size() - 1);
    for (; slots_[at].node != no_index; at = (at + 1) & (slots_.size() - 1)) {
        if (!matches(slots_[at], hash, parent, name)) {
            continue;
        }
        const std::uint32_t node = slots_[at].node;
        if (following_[node] != no_index) {
            slots_[at].node = following_[node];
        }
        return node;  // the last of a chain stays: the slot must not become free
    }
    return no_index;
}

}  // namespace quartic
