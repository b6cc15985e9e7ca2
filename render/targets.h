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

}  // namespace quartic
