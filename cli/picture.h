// Pictures as bytes: averages of several draws, and ids and normals as colours.
#pragma once

#include "render/renderer.h"

#include <cstdint>
#include <vector>

namespace quartic::cli {

// Where sample i of a pixel lies, from its centre, within half a pixel; sample 0 is the centre.
glm::dvec2 sample_offset_px(int i);

// Averages pictures in linear light, as a camera would: averaging encoded colours darkens edges.
class Average {
public:
    void add(const std::vector<std::uint8_t>& rgba);
    std::vector<std::uint8_t> rgba() const;

private:
    std::vector<glm::vec4> sums_;  // linear, multiplied by alpha
    int count_ = 0;
};

// The eight bits that stand for a linear value.
std::uint8_t srgb_of(float linear);

// Red, green and blue are the highest, middle and lowest byte of the part's number; the background
// is transparent.
std::vector<std::uint8_t> ids_as_rgba(const GBuffer& picture);

// A component n of the world normal is round((n + 1) / 2 * 255); the background is transparent.
std::vector<std::uint8_t> normals_as_rgba(const GBuffer& picture);

}  // namespace quartic::cli
