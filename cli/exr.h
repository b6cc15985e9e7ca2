// OpenEXR files of depth: one channel Z of 32-bit floats.
#pragma once

#include "diagnostics/result.h"
#include "scene/camera.h"

#include <span>
#include <string>

namespace quartic::cli {

// Rows from the bottom up. Metres along the view's axis; the background is infinite.
Status write_depth_exr(const std::string& path, PixelSize size, std::span<const float> depth_m);

}  // namespace quartic::cli
