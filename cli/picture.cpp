// Averages and encodes pictures.
#include "cli/picture.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace quartic::cli {
namespace {

// IEC 61966-2-1, both ways.
float linear_of(std::uint8_t srgb) {
    const float x = static_cast<float>(srgb) / 255.0f;
    return x <= 0.04045f ? x / 12.92f : std::pow((x + 0.055f) / 1.055f, 2.4f);
}

// The digits of i in this base, mirrored at the point (Halton 1960).
double radical_inverse(int i, int radix) {
    double value = 0.0;
    double digit = 1.0 / radix;
    for (; i > 0; i /= radix, digit /= radix) {
        value += digit * (i % radix);
    }
    return value;
}

std::uint8_t byte_of(float unit) {
    return static_cast<std::uint8_t>(std::lround(255.0f * std::clamp(unit, 0.0f, 1.0f)));
}

}  // namespace

glm::dvec2 sample_offset_px(int i) {
    if (i == 0) {
        return glm::dvec2(0.0);
    }
    return {radical_inverse(i, 2) - 0.5, radical_inverse(i, 3) - 0.5};
}

std::uint8_t srgb_of(float linear) {
    const float x = std::clamp(linear, 0.0f, 1.0f);
    return byte_of(x <= 0.0031308f ? 12.92f * x : 1.055f * std::pow(x, 1.0f / 2.4f) - 0.055f);
}

void Average::add(const std::vector<std::uint8_t>& rgba) {
    static const std::array<float, 256> linear = [] {
        std::array<float, 256> table{};
        for (std::size_t i = 0; i < table.size(); ++i) {
            table[i] = linear_of(static_cast<std::uint8_t>(i));
        }
        return table;
    }();
    sums_.resize(rgba.size() / 4, glm::vec4(0.0f));
    for (std::size_t i = 0; i < sums_.size(); ++i) {
        const float alpha = static_cast<float>(rgba[4 * i + 3]) / 255.0f;
        const glm::vec3 colour(linear[rgba[4 * i]], linear[rgba[4 * i + 1]],
                               linear[rgba[4 * i + 2]]);
        sums_[i] += glm::vec4(alpha * colour, alpha);
    }
    ++count_;
}

std::vector<std::uint8_t> Average::rgba() const {
    std::vector<std::uint8_t> bytes;
    bytes.reserve(4 * sums_.size());
    for (const glm::vec4& sum : sums_) {
        const float alpha = sum.w > 0.0f ? sum.w : 1.0f;
        bytes.push_back(srgb_of(sum.x / alpha));
        bytes.push_back(srgb_of(sum.y / alpha));
        bytes.push_back(srgb_of(sum.z / alpha));
        bytes.push_back(byte_of(sum.w / static_cast<float>(std::max(count_, 1))));
    }
    return bytes;
}

std::vector<std::uint8_t> ids_as_rgba(const GBuffer& picture) {
    std::vector<std::uint8_t> bytes(4 * picture.ids.size(), 0);
    for (std::size_t i = 0; i < picture.ids.size(); ++i) {
        const std::uint32_t id = picture.ids[i];
        if (id != no_index) {
            bytes[4 * i] = static_cast<std::uint8_t>(id >> 16);
            bytes[4 * i + 1] = static_cast<std::uint8_t>(id >> 8);
            bytes[4 * i + 2] = static_cast<std::uint8_t>(id);
            bytes[4 * i + 3] = 255;
        }
    }
    return bytes;
}

std::vector<std::uint8_t> normals_as_rgba(const GBuffer& picture) {
    std::vector<std::uint8_t> bytes(4 * picture.ids.size(), 0);
    for (std::size_t i = 0; i < picture.ids.size(); ++i) {
        if (picture.ids[i] != no_index) {
            const glm::vec3 unit = 0.5f * (picture.normals[i] + 1.0f);
            bytes[4 * i] = byte_of(unit.x);
            bytes[4 * i + 1] = byte_of(unit.y);
            bytes[4 * i + 2] = byte_of(unit.z);
            bytes[4 * i + 3] = 255;
        }
    }
    return bytes;
}

}  // namespace quartic::cli
