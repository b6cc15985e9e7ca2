// The verb check: every pixel of the GPU's pictures against rays cast in double precision.
#include "cli/arguments.h"
#include "cli/model.h"
#include "cli/signals.h"
#include "cli/solvers.h"
#include "cli/verbs.h"
#include "render/context.h"
#include "render/renderer.h"
#include "scene/compare.h"
#include "solvers/solver_table.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdio>
#include <memory>
#include <numbers>
#include <random>

namespace quartic::cli {
namespace {

using nlohmann::ordered_json;

constexpr std::array<bool, layer_count> all_layers{true, true, true, true};

struct CheckArguments {
    std::vector<std::string> files;
    int views = 12;
    std::string size = "640x480";
    SolverArguments solvers;
    std::uint32_t seed = 1;
    bool software = false;
    Reporting reporting;
};

struct Checked {
    std::string renderer;
    PixelSize size;
    Comparison comparison;
    ErrorFigures depth_error;
    ErrorFigures normal_error_deg;
    std::uint64_t nan_pixels = 0;
    std::vector<std::string> gl_errors;

    bool holds() const {
        return comparison.missed.hard + comparison.false_hits.hard + comparison.wrong_id.hard ==
                   0 &&
               nan_pixels == 0 && gl_errors.empty();
    }
};

// The views are spread evenly; the seed turns them.
glm::dvec3 view_direction(int i, int count, std::uint32_t seed) {
    std::mt19937 random(seed);
    const double turn = 2.0 * std::numbers::pi * static_cast<double>(random()) / 4294967296.0;
    return spread_direction(i, count, turn);
}

// One part and what is around it, in the direction of a view of the whole model.
Camera close_camera(const Camera& whole, const Scene& scene, std::uint32_t part) {
    const Box3 box = world_bounds(scene, scene.parts[part]);
    const double extent = std::max(glm::length(box.high - box.low), 1e-3);
    const glm::dvec3 forward = glm::normalize(whole.target - whole.eye);
    const glm::dvec3 aside = 0.5 * (box.low + box.high) - whole.target;
    Camera camera = whole;
    camera.target += aside;
    if (camera.projection == Projection::perspective) {
        camera.eye = camera.target - 4.0 * extent * forward;
        camera.near_m = 0.1 * extent;
    } else {
        camera.eye += aside - glm::dot(aside, forward) * forward;
        camera.height_m = 3.0 * extent;
    }
    return camera;
}

// All of the model, by turns in perspective and orthographic; every third view is of one part from
// close by, so that shapes are big and cut by the picture's edge.
Camera view_camera(int i, const CheckArguments& arguments, const Scene& scene, const Box3& box,
                   PixelSize size) {
    const glm::dvec3 direction = view_direction(i, arguments.views, arguments.seed);
    const glm::dvec3 up = std::abs(direction.z) > 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, 1);
    Camera like;
    like.projection = i % 2 == 0 ? Projection::perspective : Projection::orthographic;
    const Camera whole = fit_camera(box, direction, up, like, size);
    if (i % 3 != 2 || scene.parts.empty()) {
        return whole;
    }
    std::mt19937 random(arguments.seed + static_cast<std::uint32_t>(i));
    return close_camera(whole, scene, static_cast<std::uint32_t>(random() % scene.parts.size()));
}

RenderOptions check_options() {
    RenderOptions options;
    options.layers = all_layers;
    options.cull_size = false;
    options.size_min_px = 0.0;
    options.edges = false;
    options.occlusion = false;
    return options;
}

Result<Renderer> make_renderer(const Scene& scene, const CheckArguments& arguments) {
    Result<Renderer> renderer = Renderer::create();
    if (!renderer) {
        return renderer;
    }
    PackOptions packing;
    packing.transparent_as_opaque = true;
    packing.solver = solver_number(arguments.solvers.everywhere);
    const Status loaded = renderer.value().load(pack(scene, packing));
    if (!loaded) {
        return loaded.error();
    }
    return renderer;
}

Result<Checked> compare_views(const Scene& scene, const CheckArguments& arguments) {
    const auto context = HeadlessContext::create(arguments.software ? ContextKind::software
                                                                    : ContextKind::automatic);
    if (!context) {
        return context.error();
    }
    Result<Renderer> created = make_renderer(scene, arguments);
    if (!created) {
        return created.error();
    }
    Renderer& renderer = created.value();
    // Always with the default solver: what another one misses is missed.
    const Reference reference(scene, all_layers, solver_default);
    const Box3 box = world_bounds(scene, all_layers);
    Checked checked;
    checked.renderer = renderer_name().renderer;
    checked.size = *find_size(arguments.size);
    for (int i = 0; i < arguments.views && !is_interrupted(); ++i) {
        const Camera camera = view_camera(i, arguments, scene, box, checked.size);
        const Status drawn = renderer.draw(camera, checked.size, check_options());
        if (!drawn) {
            return drawn.error();
        }
        const GBuffer picture = renderer.read();
        compare(reference, make_view(camera, checked.size), picture_of(picture),
                checked.comparison);
        checked.nan_pixels += picture.nan_pixels;
    }
    checked.comparison.views = static_cast<std::uint64_t>(arguments.views);
    checked.gl_errors = renderer.gl_errors();
    checked.depth_error = figures(checked.comparison.depth_errors);
    checked.normal_error_deg = figures(checked.comparison.normal_errors_deg);
    return checked;
}

ordered_json as_json(const HardAndTie& pixels) {
    return {{"hard", pixels.hard}, {"tie", pixels.tie}};
}

ordered_json as_json(const ErrorFigures& error) {
    return {{"median", error.median}, {"p9999", error.p9999}, {"max", error.max}};
}

ordered_json as_json(const std::vector<WrongPixel>& pixels) {
    const auto part = [](std::uint32_t id) { return id == no_index ? -1 : std::int64_t{id}; };
    ordered_json list = ordered_json::array();
    for (const WrongPixel& pixel : pixels) {
        list.push_back({{"view", pixel.view},
                        {"x", pixel.x},
                        {"y", pixel.y},
                        {"seen_part", part(pixel.seen)},
                        {"true_part", part(pixel.truth)},
                        {"seen_depth_m", pixel.seen_depth_m},
                        {"true_depth_m", pixel.true_depth_m}});
    }
    return list;
}

// "view 3, pixel 10,20: the picture shows cylinder 5 at 3.2 m, the reference torus 6 at 3.1 m".
std::string as_text(const Scene& scene, const WrongPixel& pixel) {
    const auto thing = [&](std::uint32_t id, double depth_m) {
        if (id == no_index) {
            return std::string("nothing");
        }
        std::array<char, 96> text{};
        std::snprintf(text.data(), text.size(), "%s %u at %.6g m",
                      std::string(name(scene.parts[id].type)).c_str(), id, depth_m);
        return std::string(text.data());
    };
    return "view " + std::to_string(pixel.view) + ", pixel " + std::to_string(pixel.x) + "," +
           std::to_string(pixel.y) + ": the picture shows " +
           thing(pixel.seen, pixel.seen_depth_m) + ", the reference " +
           thing(pixel.truth, pixel.true_depth_m) + "\n";
}

ordered_json as_json(const Model& model, const CheckArguments& arguments, const Checked& checked) {
    const Comparison& comparison = checked.comparison;
    return {{"schema", json_schema},
            {"file", model.path},
            {"renderer", checked.renderer},
            {"size", {checked.size.width, checked.size.height}},
            {"seed", arguments.seed},
            {"views", comparison.views},
            {"hit_pixels", comparison.hit_pixels},
            {"missed", as_json(comparison.missed)},
            {"false", as_json(comparison.false_hits)},
            {"wrong_id", as_json(comparison.wrong_id)},
            {"depth_error", as_json(checked.depth_error)},
            {"normal_error_deg", as_json(checked.normal_error_deg)},
            {"nan_pixels", checked.nan_pixels},
            {"gl_errors", checked.gl_errors.size()},
            {"wrong_pixels", as_json(comparison.wrong_pixels)}};
}

std::string row(const char* label, const HardAndTie& pixels) {
    std::array<char, 96> text{};
    std::snprintf(text.data(), text.size(), "%-18s %10llu hard %10llu ties\n", label,
                  static_cast<unsigned long long>(pixels.hard),
                  static_cast<unsigned long long>(pixels.tie));
    return text.data();
}

std::string row(const char* label, const ErrorFigures& error) {
    std::array<char, 128> text{};
    std::snprintf(text.data(), text.size(), "%-18s median %.3g, 99.99 %% %.3g, max %.3g\n", label,
                  error.median, error.p9999, error.max);
    return text.data();
}

std::string as_text(const Model& model, const Checked& checked) {
    const Comparison& comparison = checked.comparison;
    std::string text = model.path + ", " + checked.renderer + "\n";
    text += "views              " + std::to_string(comparison.views) + " of " +
            std::to_string(checked.size.width) + "x" + std::to_string(checked.size.height) + "\n";
    text += "hit pixels         " + std::to_string(comparison.hit_pixels) + "\n";
    text += row("missed", comparison.missed) + row("false", comparison.false_hits) +
            row("wrong id", comparison.wrong_id) + row("depth error", checked.depth_error) +
            row("normal error deg", checked.normal_error_deg);
    text += "not a number       " + std::to_string(checked.nan_pixels) + " pixels\n";
    text += "OpenGL errors      " + std::to_string(checked.gl_errors.size()) + "\n";
    for (const WrongPixel& pixel : comparison.wrong_pixels) {
        text += as_text(model.scene, pixel);
    }
    return text + (checked.holds() ? "holds\n" : "does not hold\n");
}

ExitCode check_model(const std::string& path, const CheckArguments& arguments,
                     ordered_json& documents, std::string& text) {
    Result<Model> model = load_model(path, arguments.reporting);
    if (!model) {
        return report_error(model.error());
    }
    prepare(arguments.solvers, model.value().scene);
    const Result<Checked> checked = compare_views(model.value().scene, arguments);
    if (!checked) {
        return report_error(checked.error());
    }
    documents.push_back(as_json(model.value(), arguments, checked.value()));
    text += as_text(model.value(), checked.value());
    for (const std::string& error : checked.value().gl_errors) {
        report_error({ErrorKind::bad_data, path, "OpenGL: " + error});
    }
    const ExitCode lost = report_findings(path, model.value().scene.findings, arguments.reporting);
    return worse_of(checked.value().holds() ? exit_ok : exit_failed, lost);
}

// One model: its document. Several: a list of them.
ExitCode check(const CheckArguments& arguments) {
    ordered_json documents = ordered_json::array();
    std::string text;
    ExitCode code = exit_ok;
    for (const std::string& path : arguments.files) {
        code = worse_of(code, check_model(path, arguments, documents, text));
    }
    if (documents.empty() || is_interrupted()) {
        return code;
    }
    if (!arguments.reporting.json) {
        return worse_of(code, print_text(text));
    }
    return worse_of(code, arguments.files.size() == 1
                              ? print_json(documents[0])
                              : print_json({{"schema", json_schema}, {"files", documents}}));
}

}  // namespace

void add_check(CLI::App& program, Run& run) {
    const auto arguments = std::make_shared<CheckArguments>();
    CLI::App& verb = *program.add_subcommand(
        "check", "compare the GPU's pictures with rays cast in double precision");
    verb.footer("Example: quartic check plant.rvm --views 12 --size 640x480");
    verb.add_option("FILE", arguments->files, "models; - is standard input")
        ->required()
        ->default_str("");
    verb.add_option("--views", arguments->views, "how many, from all sides")
        ->check(CLI::Range(1, 10000));
    verb.add_option("--size", arguments->size, "WxH in pixels")->check(check_size);
    add_solvers(verb, arguments->solvers);
    verb.add_option("--seed", arguments->seed, "turns the views");
    verb.add_flag("--software", arguments->software, "Mesa's software OpenGL");
    add_reporting(verb, arguments->reporting);
    verb.callback([&run, arguments] { run = [arguments] { return check(*arguments); }; });
}

}  // namespace quartic::cli
