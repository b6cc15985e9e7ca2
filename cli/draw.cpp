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

RenderOptions draw_options(const RenderArguments& arguments) {
    RenderOptions options = render_options(arguments);
    options.inspect = counts_cost(arguments);
    options.cull_size = !compares(arguments);
    return options;
}

// One frame, finished; its time by the wall's clock.
Result<double> timed_draw(Renderer& renderer, const Camera& camera, PixelSize size,
                          const RenderOptions& options) {
    const Moment start = now();
    const Status drawn = renderer.draw(camera, size, options);
    if (!drawn) {
        return drawn.error();
    }
    renderer.finish();
    return elapsed_ms(start);
}

Status draw_samples(Renderer& renderer, const Camera& camera, const RenderArguments& arguments,
                    Drawn& drawn) {
    RenderOptions options = draw_options(arguments);
    drawn.picture = renderer.read();
    drawn.counts = renderer.counts();
    Average average;
    average.add(drawn.picture.colours);
    for (int i = 1; i < arguments.samples && !is_interrupted(); ++i) {
        options.jitter_px = sample_offset_px(i);
        const Status sample = renderer.draw(camera, drawn.picture.size, options);
        if (!sample) {
            return sample.error();
        }
        average.add(renderer.read().colours);
    }
    drawn.colours = arguments.samples > 1 ? average.rgba() : drawn.picture.colours;
    return Done{};
}

Status time_frames(Renderer& renderer, const Camera& camera, PixelSize size,
                   const RenderArguments& arguments, Drawn& drawn) {
    const RenderOptions options = draw_options(arguments);
    for (int i = 0; i < warm_up_frames + arguments.frames && !is_interrupted(); ++i) {
        const Result<double> time_ms = timed_draw(renderer, camera, size, options);
        if (!time_ms) {
            return time_ms.error();
        }
        if (i >= warm_up_frames) {
            drawn.frame_ms.push_back(time_ms.value());
        }
    }
    return Done{};
}

struct Request {
    const RenderArguments* arguments;
    PixelSize size;
    int solver;
};

// One picture, all of it drawn by one solver or by the materials' own (0).
Result<Drawn> draw_picture(Renderer& renderer, const Scene& scene, const Camera& camera,
                           const Request& request) {
    const RenderArguments& arguments = *request.arguments;
    PackOptions packing;
    packing.solver = request.solver;
    packing.transparent_as_opaque = compares(arguments);
    const Status loaded = renderer.load(pack(scene, packing));
    if (!loaded) {
        return loaded.error();
    }
    const Result<double> first =
        timed_draw(renderer, camera, request.size, draw_options(arguments));
    if (!first) {
        return first.error();
    }
    Drawn drawn;
    drawn.first_frame_ms = first.value();
    drawn.renderer = renderer_name().renderer;
    for (const Status& step : {draw_samples(renderer, camera, arguments, drawn),
                               time_frames(renderer, camera, request.size, arguments, drawn)}) {
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
    Result<Drawn> drawn = draw_picture(
        renderer, scene, camera, {&arguments, size, solver_number(arguments.solvers.everywhere)});
    const std::string second_name = second_solver(arguments);
    std::optional<Result<Drawn>> second;
    if (drawn && !second_name.empty()) {
        second =
            draw_picture(renderer, scene, camera, {&arguments, size, solver_number(second_name)});
        if (!*second) {
            return second->error();
        }
    }
    if (drawn && !arguments.map.empty()) {
        show_map(scene, make_view(camera, size), arguments, second ? &second->value() : nullptr,
                 drawn.value());
    } else if (drawn && second) {
        show_halves(arguments, second->value(), drawn.value());
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
