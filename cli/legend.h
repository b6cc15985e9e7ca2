// What is written into pictures of maps and into split pictures.
#pragma once

#include "scene/map_picture.h"

#include <string>

namespace quartic::cli {

// Where the right half of a split picture begins.
int divider_of(PixelSize size);

// In the lower left corner; pictures that are too small for it stay without.
void draw_legend(std::vector<std::uint8_t>& rgba, PixelSize size, const Legend& legend);

// A thin line in the middle, and a name over each half.
void draw_divider(std::vector<std::uint8_t>& rgba, PixelSize size, const std::string& left,
                  const std::string& right);

}  // namespace quartic::cli
