// The benchmark solvers: a model drawn with every solver in turn: how fast, and how right.
#include "bench/stage.h"
#include "importers/load.h"
#include "scene/compare.h"
#include "scene/joints.h"
#include "solvers/solver_table.h"

#include <algorithm>

namespace quartic {
namespace {

using nlohmann::ordered_json;

constexpr std::array<bool, layer_count> all_layers{true, true, true, true};

struct Method {
    std::string name;
    std::shared_ptr<const Packed> packed;
    Comparison comparison;
    std::uint64_t nan_pixels = 0;
    bool is_compared = true;
};

// Solvers of anything that the model has; none of them: the default one alone.
std::vector<Method> make_methods(const Scene& scene) {
    const auto concerns = [&](const SolverRow& row) {
        return std::any_of(scene.parts.begin(), scene.parts.end(),
                           [&](const Part& part) { return solves(row, name(part.type)); });
    };
    std::vector<Method> methods;
    const auto add = [&](std::string_view title, int solver) {
        methods.push_back(
            {std::string(title), pack_for(scene, solver), {}, 0, solver != solver_none});
    };
    for (const SolverRow& row : solver_table()) {
        if (row.id == solver_default || concerns(row)) {
            add(row.name, row.id);
        }
    }
    add("none", solver_none);
    return methods;
}

// All of the model from sides spread evenly, every other view close to its middle.
std::vector<Camera> make_cameras(const Scene& scene, PixelSize size, int views) {
    const std::vector<Box3> boxes = part_boxes(scene, all_layers);
    std::vector<Camera> cameras;
    for (int i = 0; i < views; ++i) {
        const glm::dvec3 direction = spread_direction(i, views);
        const glm::dvec3 up =
            std::abs(direction.z) > 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, 1);
        Camera& camera = cameras.emplace_back(fit_camera(boxes, direction, up, {}, size));
        if (i % 2 == 1) {
            camera.fov_y *= 0.25;
        }
    }
    return cameras;
}

Status compare_all(Stage& stage, const Scene& scene, const std::vector<FrameCase>& frames,
                   std::vector<Method>& methods, const BenchSettings& settings) {
    // Always with the default solver: what another one misses is missed.
    const Reference reference(scene, all_layers, solver_default);
    for (std::size_t i = 0; i < frames.size(); ++i) {
        Method& method = methods[i % methods.size()];
        if (!method.is_compared) {
            continue;
        }
        if (settings.is_stopped()) {
            return Error{ErrorKind::interrupted, "", "interrupted"};
        }
        settings.note("comparing " + method.name);
        const Result<GBuffer> drawn = stage.draw(frames[i]);
        if (!drawn) {
            return drawn.error();
        }
        const GBuffer& picture = drawn.value();
        compare(reference, make_view(frames[i].camera, frames[i].size),
                {picture.size, picture.ids, picture.depth_m, picture.normals}, method.comparison);
        method.nan_pixels += picture.nan_pixels;
    }
    return Done{};
}

// The rounds of one method, summed over the views.
Rounds rounds_of(const std::vector<Rounds>& timed, std::size_t method, std::size_t method_count) {
    std::vector<Rounds> views;
    for (std::size_t i = method; i < timed.size(); i += method_count) {
        views.push_back(timed[i]);
    }
    return sum_of(views);
}

void add_comparison(Method& method, ordered_json& row) {
    Comparison& comparison = method.comparison;
    row["hit_pixels"] = comparison.hit_pixels;
    const auto add = [&](const std::string& key, const HardAndTie& pixels) {
        row[key + "_hard"] = pixels.hard;
        row[key] = pixels.hard + pixels.tie;
    };
    add("missed", comparison.missed);
    add("false", comparison.false_hits);
    add("wrong_id", comparison.wrong_id);
    row["nan_pixels"] = method.nan_pixels;
    const auto add_error = [&](const std::string& key, std::vector<float>& errors) {
        const ErrorFigures error = figures(errors);
        row[key + "_median"] = error.median;
        row[key + "_p9999"] = error.p9999;
        row[key + "_max"] = error.max;
    };
    add_error("depth_error", comparison.depth_errors);
    add_error("normal_error_deg", comparison.normal_errors_deg);
}

Status measure_model(Stage& stage, const std::string& path, PixelSize size,
                     const BenchSettings& settings, ordered_json& rows) {
    Progress progress;
    Result<Scene> loaded = load_scene(path, {}, progress);
    if (!loaded) {
        return loaded.error();
    }
    Scene& scene = loaded.value();
    find_joints(scene);
    std::vector<Method> methods = make_methods(scene);
    const std::vector<Camera> cameras = make_cameras(scene, size, settings.views);
    std::vector<FrameCase> frames;
    for (const Camera& camera : cameras) {
        for (const Method& method : methods) {
            frames.push_back({method.name, method.packed, camera, size, bench_options()});
        }
    }
    const Status compared = compare_all(stage, scene, frames, methods, settings);
    if (!compared) {
        return compared;
    }
    settings.note("timing " + std::to_string(settings.rounds) + " rounds");
    const Result<std::vector<Rounds>> timed = stage.time(frames, settings, 0.0);
    if (!timed) {
        return timed.error();
    }
    const Rounds base = rounds_of(timed.value(), 0, methods.size());
    const Rounds none = rounds_of(timed.value(), methods.size() - 1, methods.size());
    for (std::size_t i = 0; i < methods.size(); ++i) {
        const Rounds rounds = rounds_of(timed.value(), i, methods.size());
        ordered_json row{{"file", path},
                         {"method", methods[i].name},
                         {"frame_ms", 1e3 * median(rounds) / settings.views},
                         {"ratio_to_convexity_split", median_ratio(base, rounds)}};
        if (methods[i].is_compared) {
            row["solver_only_ratio_to_convexity_split"] = median_ratio(base, rounds, none, none);
            add_comparison(methods[i], row);
        }
        rows.push_back(std::move(row));
    }
    return Done{};
}

Table rows_table() {
    Table table;
    table.key = "rows";
    table.columns = {{"file", "file", {}},
                     {"method", "method", {}},
                     {"frame_ms", "ms", {}},
                     {"ratio_to_convexity_split", "x convexity_split", {}},
                     {"solver_only_ratio_to_convexity_split", "x solver only", {}},
                     {"hit_pixels", "", {}},
                     {"missed_hard", "missed hard", {}},
                     {"missed", "missed", {}},
                     {"false_hard", "false hard", {}},
                     {"false", "false", {}},
                     {"wrong_id_hard", "wrong part hard", {}},
                     {"wrong_id", "wrong part", {}},
                     {"nan_pixels", "", {}},
                     {"depth_error_median", "depth error median", {}},
                     {"depth_error_p9999", "99.99 %", {}},
                     {"depth_error_max", "max", {}},
                     {"normal_error_deg_median", "normal error deg median", {}},
                     {"normal_error_deg_p9999", "99.99 %", {}},
                     {"normal_error_deg_max", "max", {}}};
    return table;
}

Plot plot_of(const ordered_json& rows, const Conditions& conditions) {
    Plot plot;
    plot.title = "Solvers on models: frame time";
    plot.caption = as_text(conditions);
    plot.x.label = "milliseconds a frame";
    plot.series.push_back({"frame", {}});
    for (const ordered_json& row : rows) {
        const std::string path = row["file"];
        plot.series[0].points.push_back(
            {row["frame_ms"], static_cast<double>(plot.categories.size())});
        plot.categories.push_back(path.substr(path.rfind('/') + 1) + ", " +
                                  row["method"].get<std::string>());
    }
    return plot;
}

}  // namespace

Result<Report> bench_solvers(const BenchSettings& settings) {
    if (settings.files.empty()) {
        return Error{ErrorKind::usage, "bench solvers",
                     "expected a model, found none; name a file, such as one that `quartic "
                     "generate elbows -o elbows.rvm` makes"};
    }
    const PixelSize size = settings.size.width > 0 ? settings.size : PixelSize{640, 480};
    Result<Stage> stage = Stage::open(settings.software);
    if (!stage) {
        return stage.error();
    }
    Table table = rows_table();
    for (const std::string& path : settings.files) {
        const Status measured = measure_model(stage.value(), path, size, settings, table.rows);
        if (!measured) {
            return measured.error();
        }
    }
    Report report;
    report.bench = "solvers";
    report.conditions = stage.value().conditions(size, settings.rounds);
    report.plot = plot_of(table.rows, report.conditions);
    report.tables.push_back(std::move(table));
    report.notes = {"Of " + std::to_string(settings.views) +
                    " views. Depth errors are relative. The truth is cast in double precision with "
                    "the default solver; hard: no ray within 0.01 pixels sees what the picture "
                    "shows."};
    return report;
}

}  // namespace quartic
