// A scene whose shapes are triangles, to compare the exact surfaces with.
#pragma once

#include "scene/scene.h"

namespace quartic::cli {

// The same parts, each a mesh that departs from its shape by at most the sagitta (metres).
Scene tessellated(const Scene& scene, double sagitta);

}  // namespace quartic::cli
