// An OpenGL 4.5 core context without a window: EGL surfaceless on Mesa, an EGL device on NVIDIA.
#pragma once

#include "diagnostics/result.h"

#include <string>

namespace quartic {

enum class ContextKind {
    automatic,
    software
};  // software: Mesa's llvmpipe, whatever hardware there is

class HeadlessContext {
public:
    // Makes the context current on this thread. The error lists what was tried.
    static Result<HeadlessContext> create(ContextKind kind = ContextKind::automatic);

    HeadlessContext(HeadlessContext&& other) noexcept;
    HeadlessContext& operator=(HeadlessContext&&) = delete;
    ~HeadlessContext();

private:
    HeadlessContext() = default;
    void* display_ = nullptr;
    void* context_ = nullptr;
};

// Of the current context.
struct RendererName {
    std::string renderer;
    std::string version;
    bool software = false;  // GL timers lie there: use the wall clock
};
RendererName renderer_name();

// Names the first thing that the renderer needs and the current context lacks, or nothing.
Status check_context();

}  // namespace quartic
