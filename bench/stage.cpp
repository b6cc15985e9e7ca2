// Draws frames for benchmarks.
#include "bench/stage.h"

#include <utility>

namespace quartic {

RenderOptions bench_options() {
    RenderOptions options;
    options.layers = {true, true, true, true};
    options.cull_size = false;
    options.edges = false;
    options.occlusion = false;
    options.lighting = false;
    return options;
}

std::shared_ptr<const Packed> pack_for(const Scene& scene, int solver) {
    PackOptions options;
    options.transparent_as_opaque = true;
    options.solver = solver;
    return std::make_shared<const Packed>(pack(scene, options));
}

Stage::Stage(HeadlessContext context, Renderer renderer)
    : context_(std::move(context)), renderer_(std::move(renderer)), name_(renderer_name()) {}

Result<Stage> Stage::open(bool software) {
    Result<HeadlessContext> context =
        HeadlessContext::create(software ? ContextKind::software : ContextKind::automatic);
    if (!context) {
        return context.error();
    }
    Result<Renderer> renderer = Renderer::create();
    if (!renderer) {
        return renderer.error();
    }
    return Stage(std::move(context).value(), std::move(renderer).value());
}

Conditions Stage::conditions(PixelSize size, int rounds) const {
    return {name_.renderer, name_.software, size, rounds};
}

Status Stage::show(const std::shared_ptr<const Packed>& packed) {
    if (packed == shown_) {
        return Done{};
    }
    shown_ = packed;
    return renderer_.load(*packed);
}

Result<std::vector<Rounds>> Stage::time(std::span<const FrameCase> frames, const BenchSettings& how,
                                        double batch_s) {
    std::vector<TimedCase> cases;
    for (const FrameCase& frame : frames) {
        const auto draw = [this, &frame] {
            const Status drawn = renderer_.draw(frame.camera, frame.size, frame.options);
            renderer_.finish();
            return drawn;
        };
        cases.push_back({frame.name, [this, &frame] { return show(frame.packed); }, draw});
    }
    TimingOptions options;
    options.rounds = how.rounds;
    options.batch_s = batch_s;
    options.is_stopped = how.is_stopped;
    return time_interleaved(cases, options);
}

Result<GBuffer> Stage::inspect(const FrameCase& frame) {
    FrameCase inspected = frame;
    inspected.options.inspect = true;
    return draw(inspected);
}

Result<GBuffer> Stage::draw(const FrameCase& frame) {
    Status status = show(frame.packed);
    status = status ? renderer_.draw(frame.camera, frame.size, frame.options) : status;
    if (!status) {
        return status.error();
    }
    return renderer_.read();
}

}  // namespace quartic
