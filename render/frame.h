// One frame: a straight sequence of passes over plain buffers.
#pragma once

#include "render/renderer.h"
#include "render/scene_buffers.h"
#include "render/targets.h"

#include <array>

namespace quartic {

struct FramePrograms {
    std::array<GlProgram, 3> cull;  // decide, offsets, lists
    GlProgram resolve;
};

struct FrameOptions {
    Proxy proxy = Proxy::automatic;
    bool lighting = true;  // the pass that makes colours
    bool transparent_background = false;
};

// Draws the scene into the targets, from the camera in the buffer (gpu::CameraBlock).
void draw_frame(const SceneBuffers& scene, const Targets& targets, const FramePrograms& programs,
                GLuint camera, FrameOptions options);

}  // namespace quartic
