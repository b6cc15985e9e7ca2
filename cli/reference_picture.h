// Pictures without a GPU: the scene's rays cast in double, lit from the eye.
#pragma once

#include "render/renderer.h"
#include "scene/reference.h"

namespace quartic::cli {

// The same targets as the renderer fills. All threads of the machine work; the result does not
// depend on how many they are. Stops early, with rows left empty, when a signal comes.
GBuffer draw_reference(const Scene& scene, const Reference& reference, const View& view,
                       glm::dvec2 jitter_px);

}  // namespace quartic::cli
