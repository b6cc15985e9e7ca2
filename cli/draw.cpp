// Draws the pictures of the verb render.
#include "cli/arguments.h"
#include "cli/model.h"
#include "cli/picture.h"
#include "cli/reference_picture.h"
#include "cli/render.h"
#include "cli/signals.h"
#include "render/context.h"

namespace quartic::cli {
namespace {

constexpr int warm_up_frames = 2;

// Costs are those of an ordinary frame; what is compared is drawn whole and opaque, as in check.
bool counts_cost(const RenderArguments& arguments) {
    return arguments.map == row_of(MapKind::steps).name ||
           arguments.map == row_of(MapKind::rays).name;
}

bool compares(const RenderArguments& arguments) {
    return !arguments.map.empty() && !counts_cost(arguments);
}

RenderOptions shot_options(const RenderArguments& arguments) {
    RenderOptions options = render_options(arguments);
    options.inspect = counts_cost(arguments);
    options.cull_size = !compares(arguments);
    options.opaque = compares(arguments);
    return options;
}

// What the samples of one picture have in common.
struct Shot {
    const Camera& camera;
    PixelSize size;
    RenderOptions options;
};

// One frame, finished; its time by the wall's clock.
Result<double> timed_draw(Renderer& renderer, const Shot& shot) {
    const Moment start = now();
    const Status drawn = renderer.draw(shot.camera, shot.size, shot.options);
    if (!drawn) {
        return drawn.error();
    }
    renderer.finish();
    return elapsed_ms(start);
}

Status draw_samples(Renderer& renderer, const Shot& shot, int samples, Drawn& drawn) {
    drawn.picture = renderer.read();
    drawn.counts = renderer.counts();
    Average average;
    average.add(drawn.picture.colours);
    RenderOptions options = shot.options;
    for (int i = 1; i < samples && !is_interrupted(); ++i) {
        options.jitter_px = sample_offset_px(i);
        const Status sample = renderer.draw(shot.camera, shot.size, options);
        if (!sample) {
            return sample.error();
        }
        average.add(renderer.read().colours);
    }
    drawn.colours = samples > 1 ? average.rgba() : drawn.picture.colours;
    return Done{};
}

Status time_frames(Renderer& renderer, const Shot& shot, int frames, Drawn& drawn) {
    for (int i = 0; i < warm_up_frames + frames && !is_interrupted(); ++i) {
        const Result<double> time_ms = timed_draw(renderer, shot);
        if (!time_ms) {
            return time_ms.error();
        }
        if (i >= warm_up_frames) {
            drawn.frame_ms.push_back(time_ms.value());
        }
    }
    return Done{};
}

Result<Drawn> draw_shot(Renderer& renderer, const Shot& shot, const RenderArguments& arguments) {
    const Result<double> first = timed_draw(renderer, shot);
    if (!first) {
        return first.error();
    }
    Drawn drawn;
    drawn.first_frame_ms = first.value();
    drawn.renderer = renderer_name().renderer;
    for (const Status& step : {draw_samples(renderer, shot, arguments.samples, drawn),
                               time_frames(renderer, shot, arguments.frames, drawn)}) {
        if (!step) {
            return step.error();
        }
    }
    drawn.gpu_bytes = renderer.gpu_bytes();
    return drawn;
}

// The name of the solver of a second picture, or empty.
std::string second_solver(const RenderArguments& arguments) {
    return arguments.map == row_of(MapKind::difference).name ? arguments.against : arguments.split;
}

}  // namespace

Result<Drawn> draw_on_gpu(const Scene& scene, const Camera& camera, PixelSize size,
                          const RenderArguments& arguments) {
    const auto context = HeadlessContext::create(arguments.software ? ContextKind::software
                                                                    : ContextKind::automatic);
    if (!context) {
        return context.error();
    }
    Result<Renderer> created = Renderer::create();
    if (!created) {
        return created.error();
    }
    Renderer& renderer = created.value();
    PackOptions packing;
    packing.solver = solver_number(arguments.solvers.everywhere);
    const Status loaded = renderer.load(pack(scene, packing));
    if (!loaded) {
        return loaded.error();
    }
    Shot shot{camera, size, shot_options(arguments)};
    Result<Drawn> drawn = draw_shot(renderer, shot, arguments);
    const std::string second_name = second_solver(arguments);
    if (!drawn || (second_name.empty() && arguments.map.empty())) {
        return drawn;
    }
    std::optional<Drawn> second;
    if (!second_name.empty()) {
        shot.options.solver = solver_number(second_name);
        Result<Drawn> other = draw_shot(renderer, shot, arguments);
        if (!other) {
            return other.error();
        }
        second = std::move(other).value();
    }
    if (arguments.map.empty()) {
        show_halves(arguments, *second, drawn.value());
    } else {
        show_map(scene, make_view(camera, size), arguments, second ? &*second : nullptr,
                 drawn.value());
    }
    return drawn;
}

Drawn draw_on_cpu(const Scene& scene, const Camera& camera, PixelSize size,
                  const RenderArguments& arguments) {
    const Reference reference(scene, render_options(arguments).layers,
                              solver_number(arguments.solvers.everywhere));
    const View view = make_view(camera, size);
    const auto draw = [&](int sample) {
        return draw_reference(scene, reference, view, sample_offset_px(sample));
    };
    Drawn drawn;
    drawn.renderer = "reference (double precision, CPU)";
    const Moment start = now();
    drawn.picture = draw(0);
    drawn.first_frame_ms = elapsed_ms(start);
    Average average;
    average.add(drawn.picture.colours);
    for (int i = 1; i < arguments.samples && !is_interrupted(); ++i) {
        average.add(draw(i).colours);
    }
    drawn.colours = arguments.samples > 1 ? average.rgba() : drawn.picture.colours;
    for (int i = 0; i < arguments.frames && !is_interrupted(); ++i) {
        const Moment frame = now();
        draw(0);
        drawn.frame_ms.push_back(elapsed_ms(frame));
    }
    return drawn;
}

}  // namespace quartic::cli
