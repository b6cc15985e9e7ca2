// The pictures that a frame is drawn into.
#pragma once

#include "render/gl_objects.h"
#include "scene/camera.h"

namespace quartic {

struct Targets {
    PixelSize size;
    GlTexture parts;         // R32UI: part ids
    GlTexture normals;       // R32UI: shaders/normals.glsl
    GlTexture depth;         // DEPTH32F, reversed
    GlTexture translucent;   // RGBA16F: weighted sums
    GlTexture revealed;      // R16F: what of the surface behind is left
    GlTexture colours;       // RGBA8: sRGB
    GlFramebuffer surfaces;  // parts, normals, depth
    GlFramebuffer blending;  // translucent, revealed, depth
    GlFramebuffer finished;  // colours
};

Targets make_targets(PixelSize size);

// What a frame writes besides while its rays are inspected (shaders/inspect.glsl).
struct InspectionTargets {
    PixelSize size;
    GlTexture counts;          // R32UI: rays and steps
    GlTexture ray_origins;     // RGBA32F: origin, first
    GlTexture ray_directions;  // RGBA32F: direction, t
    GlTexture ray_pixels;      // R32F: a pixel's width
};

InspectionTargets make_inspection_targets(PixelSize size);
// Empties them and binds them for the next frame.
void begin_inspection(const InspectionTargets& targets);

}  // namespace quartic
