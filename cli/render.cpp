// The verb render: one picture of a model, without a window.
#include "cli/arguments.h"
#include "cli/exr.h"
#include "cli/model.h"
#include "cli/picture.h"
#include "cli/png.h"
#include "cli/reference_picture.h"
#include "cli/signals.h"
#include "cli/solvers.h"
#include "cli/tessellated.h"
#include "cli/verbs.h"
#include "files/output.h"
#include "render/context.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <numbers>

namespace quartic::cli {
namespace {

constexpr int warm_up_frames = 2;

struct RenderArguments {
    std::vector<std::string> files;
    std::string output;
    std::string size = "1600x1000";
    std::string camera = "iso";
    std::string projection = "perspective";
    double fov_deg = 35.0;
    SolverArguments solvers;
    std::string device = "gpu";
    std::string mode = "raycast";
    double tolerance_mm = 1.0;
    std::string depth;
    std::string ids;
    std::string normals;
    int samples = 1;
    int frames = 0;
    bool software = false;
    bool transparent = false;
    std::vector<std::string> shown;
    std::vector<std::string> hidden;
    Reporting reporting;
};

// What the JSON tells of a picture, besides the picture.
struct Drawn {
    GBuffer picture;
    std::vector<std::uint8_t> colours;
    std::string renderer;
    FrameCounts counts;
    std::uint64_t gpu_bytes = 0;
    double first_frame_ms = 0.0;
    std::vector<double> frame_ms;
};

RenderOptions render_options(const RenderArguments& arguments) {
    RenderOptions options;
    options.layers = chosen_layers(arguments.shown, arguments.hidden);
    options.transparent_background = arguments.transparent;
    return options;
}

Result<Camera> chosen_camera(const RenderArguments& arguments, std::span<const Box3> boxes,
                             PixelSize size) {
    Camera like;
    like.projection =
        arguments.projection == "orthographic" ? Projection::orthographic : Projection::perspective;
    like.fov_y = arguments.fov_deg * std::numbers::pi / 180.0;
    const std::optional<Camera> camera = find_camera(arguments.camera, boxes, like, size);
    if (!camera) {
        return Error{ErrorKind::usage, "--camera",
                     "expected fit, iso, front, back, left, right, top, bottom or "
                     "\"ex,ey,ez;tx,ty,tz;ux,uy,uz\" (eye, target, up), found '" +
                         arguments.camera + "'"};
    }
    return *camera;
}

double median(std::vector<double> values) {
    if (values.empty()) {
        return 0.0;
    }
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
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
    RenderOptions options = render_options(arguments);
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
    const RenderOptions options = render_options(arguments);
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
    const Result<double> first = timed_draw(renderer, camera, size, render_options(arguments));
    if (!first) {
        return first.error();
    }
    Drawn drawn;
    drawn.first_frame_ms = first.value();
    drawn.renderer = renderer_name().renderer;
    for (const Status& step : {draw_samples(renderer, camera, arguments, drawn),
                               time_frames(renderer, camera, size, arguments, drawn)}) {
        if (!step) {
            return step.error();
        }
    }
    drawn.gpu_bytes = renderer.gpu_bytes();
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

ExitCode write_pictures(const RenderArguments& arguments, const Drawn& drawn) {
    const GBuffer& picture = drawn.picture;
    std::vector<Status> written;
    if (!arguments.depth.empty()) {
        written.push_back(write_depth_exr(arguments.depth, picture.size, picture.depth_m));
    }
    if (!arguments.ids.empty()) {
        written.push_back(write_png(arguments.ids, picture.size, ids_as_rgba(picture)));
    }
    if (!arguments.normals.empty()) {
        written.push_back(write_png(arguments.normals, picture.size, normals_as_rgba(picture)));
    }
    written.push_back(write_png(arguments.output, picture.size, drawn.colours));
    for (const Status& status : written) {
        if (!status) {
            return report_error(status.error());
        }
    }
    return exit_ok;
}

nlohmann::ordered_json as_json(const Model& model, const RenderArguments& arguments,
                               const Drawn& drawn) {
    const bool timed = !drawn.frame_ms.empty();
    return {{"schema", json_schema},
            {"file", model.path},
            {"renderer", drawn.renderer},
            {"size", {drawn.picture.size.width, drawn.picture.size.height}},
            {"samples", arguments.samples},
            {"frames", timed ? drawn.frame_ms.size() : 1},
            {"frame_ms_median", timed ? median(drawn.frame_ms) : drawn.first_frame_ms},
            {"frame_ms", drawn.frame_ms},
            {"clock", "wall"},
            {"first_frame_ms", drawn.first_frame_ms},
            {"load_ms", model.load_ms},
            {"drawn", drawn.counts.drawn},
            {"culled",
             {{"frustum", drawn.counts.culled_by_frustum},
              {"size", drawn.counts.culled_by_size},
              {"occlusion", 0}}},
            {"nan_pixels", drawn.picture.nan_pixels},
            {"gpu_bytes", drawn.gpu_bytes},
            {"peak_memory_bytes", peak_memory_bytes()}};
}

void report_drawn(const RenderArguments& arguments, const Model& model, const Drawn& drawn) {
    std::string text = arguments.output + ": " + std::to_string(drawn.picture.size.width) + "x" +
                       std::to_string(drawn.picture.size.height) + ", " +
                       std::to_string(model.scene.parts.size()) + " parts, " + drawn.renderer;
    if (!drawn.frame_ms.empty()) {
        std::array<char, 64> times{};
        std::snprintf(times.data(), times.size(), ", %.3f ms a frame (median of %zu)",
                      median(drawn.frame_ms), drawn.frame_ms.size());
        text += times.data();
    }
    report_note(arguments.reporting, text);
}

// Finds out before the work whether its results can be written.
Status check_outputs(const RenderArguments& arguments) {
    for (const std::string& path :
         {arguments.output, arguments.depth, arguments.ids, arguments.normals}) {
        if (path.empty()) {
            continue;
        }
        if (path == "-" && arguments.reporting.json) {
            return Error{ErrorKind::usage, "-o -",
                         "standard output cannot hold both the picture and --json; name a file"};
        }
        const std::string_view ending = path == arguments.depth ? ".exr" : ".png";
        if (path != "-" && !path.ends_with(ending)) {
            return Error{ErrorKind::usage, path,
                         "expected a name that ends in " + std::string(ending) +
                             ", the format that is written"};
        }
        const Result<Output> output = Output::create(path);
        if (!output) {
            return output.error();
        }
    }
    return Done{};
}

ExitCode render(const RenderArguments& arguments) {
    const Status writable = check_outputs(arguments);
    if (!writable) {
        return report_error(writable.error());
    }
    Result<Model> loaded = load_models(arguments.files, arguments.reporting);
    if (!loaded) {
        return report_error(loaded.error());
    }
    Model& model = loaded.value();
    prepare(arguments.solvers, model.scene);
    if (arguments.mode == "tessellated") {
        model.scene = tessellated(model.scene, arguments.tolerance_mm / 1000.0);
    }
    const PixelSize size = *find_size(arguments.size);
    const std::vector<Box3> boxes = part_boxes(model.scene, render_options(arguments).layers);
    const Result<Camera> camera = chosen_camera(arguments, boxes, size);
    if (!camera) {
        return report_error(camera.error());
    }
    const Result<Drawn> drawn =
        arguments.device == "reference"
            ? Result<Drawn>(draw_on_cpu(model.scene, camera.value(), size, arguments))
            : draw_on_gpu(model.scene, camera.value(), size, arguments);
    if (!drawn) {
        return report_error(drawn.error());
    }
    if (is_interrupted()) {
        return exit_failed;
    }
    ExitCode code = write_pictures(arguments, drawn.value());
    if (code == exit_ok && arguments.reporting.json) {
        code = print_json(as_json(model, arguments, drawn.value()));
    } else if (code == exit_ok) {
        report_drawn(arguments, model, drawn.value());
    }
    return worse_of(code, report_findings(model.path, model.scene.findings, arguments.reporting));
}

void add_outputs(CLI::App& verb, RenderArguments& arguments) {
    verb.add_option("-o,--output", arguments.output, "the picture, PNG; - is standard output")
        ->required();
    verb.add_option("--depth", arguments.depth, "depth in metres, OpenEXR, one float channel Z");
    verb.add_option("--ids", arguments.ids, "part numbers, PNG: red is the highest byte");
    verb.add_option("--normals", arguments.normals, "world normals, PNG");
    verb.add_option("--frames", arguments.frames, "draw so many frames more and time them")
        ->check(CLI::Range(0, 100000));
}

void add_looks(CLI::App& verb, RenderArguments& arguments) {
    verb.add_option("--size", arguments.size, "WxH in pixels")->check(check_size);
    verb.add_option("--camera", arguments.camera,
                    "fit, iso, front, back, left, right, top, bottom or "
                    "\"ex,ey,ez;tx,ty,tz;ux,uy,uz\" (eye, target, up)");
    verb.add_option("--projection", arguments.projection, "perspective or orthographic")
        ->check(CLI::IsMember({"perspective", "orthographic"}));
    verb.add_option("--fov", arguments.fov_deg, "height of a perspective view, degrees")
        ->check(CLI::Range(1.0, 170.0));
    verb.add_option("--samples", arguments.samples, "draws that are averaged, against jagged edges")
        ->check(CLI::Range(1, 1024));
    verb.add_option("--show", arguments.shown, "a layer: normal, obstruction, insulation, lines")
        ->check(check_layer)
        ->expected(1)
        ->take_all()
        ->default_str("");
    verb.add_option("--hide", arguments.hidden, "a layer; lines are hidden unless shown")
        ->check(check_layer)
        ->expected(1)
        ->take_all()
        ->default_str("");
    verb.add_flag("--transparent", arguments.transparent, "leave the background out");
}

void add_methods(CLI::App& verb, RenderArguments& arguments) {
    add_solvers(verb, arguments.solvers);
    verb.add_option("--device", arguments.device, "gpu, or reference: the CPU in double precision")
        ->check(CLI::IsMember({"gpu", "reference"}));
    verb.add_flag("--software", arguments.software, "Mesa's software OpenGL");
    verb.add_option("--mode", arguments.mode, "raycast, or tessellated: shapes become triangles")
        ->check(CLI::IsMember({"raycast", "tessellated"}));
    verb.add_option("--tolerance", arguments.tolerance_mm,
                    "how far triangles may depart from the shapes, mm")
        ->check(CLI::Range(1e-3, 1e6));
}

}  // namespace

void add_render(CLI::App& program, Run& run) {
    const auto arguments = std::make_shared<RenderArguments>();
    CLI::App& verb = *program.add_subcommand("render", "draw one picture of a model");
    verb.footer("Example: quartic render plant.rvm -o plant.png --size 1600x1000 --samples 16");
    verb.add_option("FILE", arguments->files, "the model; - is standard input")
        ->required()
        ->default_str("");
    add_outputs(verb, *arguments);
    add_looks(verb, *arguments);
    add_methods(verb, *arguments);
    add_reporting(verb, arguments->reporting);
    verb.callback([&run, arguments] { run = [arguments] { return render(*arguments); }; });
}

}  // namespace quartic::cli
