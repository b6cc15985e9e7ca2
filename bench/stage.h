// Where benchmarks of drawing happen: a context, a renderer, and frames that are timed or
// inspected.
#pragma once

#include "bench/benches.h"
#include "bench/timing.h"
#include "render/context.h"
#include "render/renderer.h"

#include <memory>
#include <span>
#include <string>

namespace quartic {

// A frame to be timed. Frames that show the same scene share its records.
struct FrameCase {
    std::string name;
    std::shared_ptr<const Packed> packed;
    Camera camera;
    PixelSize size;
    RenderOptions options;
};

// Everything is drawn into ids, normals and depths, however small, and not lit: that pass costs
// every method the same.
RenderOptions bench_options();

// Records with every part drawn by this solver; 0: by the default one.
std::shared_ptr<const Packed> pack_for(const Scene& scene, int solver);

class Stage {
public:
    static Result<Stage> open(bool software);

    const RendererName& name() const { return name_; }
    Conditions conditions(PixelSize size, int rounds) const;

    // One result for each frame. The clock stops when the GPU has finished.
    Result<std::vector<Rounds>> time(std::span<const FrameCase> frames, const BenchSettings& how,
                                     double batch_s);

    // One frame with the record of its rays.
    Result<GBuffer> inspect(const FrameCase& frame);
    // One frame without.
    Result<GBuffer> draw(const FrameCase& frame);

    std::uint64_t gpu_bytes() const { return renderer_.gpu_bytes(); }  // of the last frame's scene
    const std::vector<std::string>& gl_errors() const { return renderer_.gl_errors(); }

private:
    Stage(HeadlessContext context, Renderer renderer);
    Status show(const std::shared_ptr<const Packed>& packed);

    HeadlessContext context_;
    Renderer renderer_;
    RendererName name_;
    std::shared_ptr<const Packed> shown_;  // held: another at its place would look like it
};

}  // namespace quartic
