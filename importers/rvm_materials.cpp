// The default palette, and linear colours from what files say in sRGB.
#include "importers/rvm_materials.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace quartic {
namespace {

// PDMS numbers its colours; the names are those of its manuals, the values those that CSS gives the
// names.
constexpr std::array<std::uint32_t, 17> palette{
    0x808080,  // 0: none; as grey
    0x808080,  // grey
    0xff0000,  // red
    0xffa500,  // orange
    0xffff00,  // yellow
    0x008000,  // green
    0x00ffff,  // cyan
    0x0000ff,  // blue
    0xee82ee,  // violet
    0xa52a2a,  // brown
    0xffffff,  // white
    0xfa8072,  // salmon
    0xd3d3d3,  // light grey
    0xd2b48c,  // tan
    0xdda0dd,  // plum
    0xf5f5f5,  // white smoke
    0x800000,  // maroon
};

// IEC 61966-2-1, section 5.2.
float linear_from_srgb(float value) {
    return value <= 0.04045f ? value / 12.92f : std::pow((value + 0.055f) / 1.055f, 2.4f);
}

// Neighbouring indices get hues far apart: steps of the golden ratio around the circle.
glm::vec3 srgb_of_unnamed(std::uint32_t index) {
    const double turn = static_cast<double>(index) * 0.6180339887498949;
    const double hue = 6.0 * (turn - std::floor(turn));
    const auto channel = [hue](double shift) {
        const double k = std::fmod(shift + hue, 6.0);
        return static_cast<float>(0.82 - 0.42 * std::clamp(std::min(k, 4.0 - k), 0.0, 1.0));
    };
    return {channel(5.0), channel(3.0), channel(1.0)};
}

glm::vec3 srgb_of_bytes(std::uint32_t rgb) {
    return glm::vec3((rgb >> 16) & 0xff, (rgb >> 8) & 0xff, rgb & 0xff) / 255.0f;
}

RvmMaterials::Key key_of(const RvmLook& look, Layer layer) {
    return (RvmMaterials::Key{look.colour} << 32) | (RvmMaterials::Key{look.transparency} << 8) |
           static_cast<RvmMaterials::Key>(layer);
}

constexpr std::array<const char*, layer_count> layer_suffixes{"", ", obstruction", ", insulation",
                                                              ", line"};

}  // namespace

void RvmColours::set(std::uint32_t index, std::uint8_t red, std::uint8_t green, std::uint8_t blue) {
    bytes_[index] = (std::uint32_t{red} << 16) | (std::uint32_t{green} << 8) | blue;
}

glm::vec3 RvmColours::linear(std::uint32_t index) const {
    const auto given = bytes_.find(index);
    glm::vec3 srgb;
    if (given != bytes_.end()) {
        srgb = srgb_of_bytes(given->second);
    } else {
        srgb = index < palette.size() ? srgb_of_bytes(palette[index]) : srgb_of_unnamed(index);
    }
    return {linear_from_srgb(srgb.r), linear_from_srgb(srgb.g), linear_from_srgb(srgb.b)};
}

std::uint32_t RvmMaterials::number_of(const RvmLook& look, Layer layer) {
    return number_of(key_of(look, layer));
}

std::uint32_t RvmMaterials::number_of(Key key) {
    if (key == last_key_) {
        return last_number_;
    }
    const auto [entry, added] = numbers_.try_emplace(key, static_cast<std::uint32_t>(keys_.size()));
    if (added) {
        keys_.push_back(key);
    }
    last_key_ = key;
    last_number_ = entry->second;
    return last_number_;
}

std::vector<Material> RvmMaterials::make(const RvmColours& colours) const {
    std::vector<Material> materials;
    materials.reserve(keys_.size());
    for (const Key key : keys_) {
        const auto colour = static_cast<std::uint32_t>(key >> 32);
        const auto transparency = static_cast<std::uint32_t>((key >> 8) & 0xff);
        Material material;
        material.name = "colour " + std::to_string(colour);
        if (transparency > 0) {
            material.name += ", " + std::to_string(transparency) + " % transparent";
        }
        material.name += layer_suffixes[key & 0xff];
        material.colour =
            glm::vec4(colours.linear(colour), 1.0f - static_cast<float>(transparency) / 100.0f);
        materials.push_back(std::move(material));
    }
    return materials;
}

}  // namespace quartic
