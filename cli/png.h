// PNG files: eight bits of red, green, blue and alpha.
#pragma once

#include "diagnostics/result.h"
#include "scene/camera.h"

#include <cstdint>
#include <span>
#include <string>

namespace quartic::cli {

// Rows from the bottom up, as they stand in GL; the file is written whole or not at all.
Status write_png(const std::string& path, PixelSize size, std::span<const std::uint8_t> rgba);

}  // namespace quartic::cli
