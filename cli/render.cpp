// The verb render: one picture of a model, without a window.
#include "cli/render.h"
#include "cli/arguments.h"
#include "cli/exr.h"
#include "cli/model.h"
#include "cli/picture.h"
#include "cli/png.h"
#include "cli/signals.h"
#include "cli/tessellated.h"
#include "cli/verbs.h"
#include "scene/map_picture.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <numbers>

namespace quartic::cli {
namespace {

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

double median(std::vector<double> values) {
    if (values.empty()) {
        return 0.0;
    }
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

void add_map(const Map& map, nlohmann::ordered_json& document) {
    const MapRow& row = row_of(map.kind);
    const MapFigures figures = figures_of(map);
    document["map"] = row.name;
    document["map_unit"] = row.unit;
    document["map_pixels"] = figures.count;
    document["map_min"] = figures.min;
    document["map_mean"] = figures.mean;
    document["map_max"] = figures.max;
    document["map_p99"] = figures.p99;
    nlohmann::ordered_json counts = nlohmann::ordered_json::object();
    for (const MapClass& one : map.class_list) {
        counts[one.name] = one.count;
    }
    document["map_counts"] = counts;
}

nlohmann::ordered_json as_json(const Model& model, const RenderArguments& arguments,
                               const Drawn& drawn) {
    const bool timed = !drawn.frame_ms.empty();
    nlohmann::ordered_json document{
        {"schema", json_schema},
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
    if (drawn.map) {
        add_map(*drawn.map, document);
    }
    return document;
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

ExitCode render(const RenderArguments& arguments) {
    const Status sensible = check_render(arguments);
    if (!sensible) {
        return report_error(sensible.error());
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

}  // namespace

void add_render(CLI::App& program, Run& run) {
    const auto arguments = std::make_shared<RenderArguments>();
    CLI::App& verb = *program.add_subcommand("render", "draw one picture of a model");
    verb.footer("Example: quartic render plant.rvm -o plant.png --size 1600x1000 --samples 16");
    verb.add_option("FILE", arguments->files, "the model; - is standard input")
        ->required()
        ->default_str("");
    add_render_options(verb, *arguments);
    verb.callback([&run, arguments] { run = [arguments] { return render(*arguments); }; });
}

}  // namespace quartic::cli
