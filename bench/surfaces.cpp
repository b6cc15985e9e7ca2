// The benchmarks cubics and quartics: every solver on famous surfaces, whole and close to their
// singular points, where polynomials in floats lose their digits.
#include "bench/scenes.h"
#include "bench/stage.h"
#include "bench/truth_columns.h"
#include "generators/gallery.h"
#include "solvers/solver_table.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace quartic {
namespace {

using nlohmann::ordered_json;

constexpr double zooms[] = {1.0, 10.0, 100.0, 1e3, 1e4};
constexpr double eye_distance = 6.7;  // the cube's corners just fill a picture of 30 degrees
constexpr double fov = 30.0 * std::numbers::pi / 180.0;
constexpr double apart = 0.01;  // of the picture's width: hits farther apart are not the same

struct Method {
    std::string name;
    int solver;
};

std::vector<Method> make_methods(std::string_view shape) {
    std::vector<Method> methods;
    for (const SolverRow& row : solver_table()) {
        if (solves(row, shape)) {
            methods.push_back({std::string(row.name), row.id});
        }
    }
    methods.push_back({"none", solver_none});
    return methods;
}

// What was measured of one method in all views of a zoom; sums over surfaces are made of them too.
struct Measured {
    Rounds rounds;
    Judgement judgement;
};

void add(const Measured& from, Measured& into) {
    into.rounds = into.rounds.empty() ? from.rounds : sum_of({{into.rounds, from.rounds}});
    add(from.judgement, into.judgement);
}

// Zooming narrows the view; the eye stays outside of the cube. The target is a singular point, each
// view another one as far as there are any.
Camera camera_of(const GallerySurface& surface, double zoom, int view, int views) {
    Camera camera;
    camera.fov_y = 2.0 * std::atan(std::tan(0.5 * fov) / zoom);
    const auto points = surface.singular_points.size();
    if (zoom > 1.0) {
        camera.target = surface.singular_points[static_cast<std::size_t>(view) % points];
    }
    const glm::dvec3 direction = spread_direction(view, views);
    camera.eye = camera.target + eye_distance * direction;
    camera.up = std::abs(direction.z) > 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, 1);
    camera.near_m = 1.0;
    return camera;
}

double pixel_size(double zoom, PixelSize size) {
    return 2.0 * std::tan(0.5 * fov) * eye_distance / (zoom * size.height);
}

using Records = std::vector<std::shared_ptr<const Packed>>;

class SurfaceBench {
public:
    SurfaceBench(Stage& stage, const BenchSettings& settings, PixelSize size,
                 std::string_view shape)
        : stage_(stage), settings_(settings), size_(size), methods_(make_methods(shape)) {}

    Status measure(const GallerySurface& surface) {
        const Scene scene = surface_scene(surface.polynomial);
        Records records;
        for (const Method& method : methods_) {
            records.push_back(pack_for(scene, method.solver));
        }
        for (const double zoom : zooms) {
            if (zoom > 1.0 && surface.singular_points.empty()) {
                continue;
            }
            settings_.note(std::string(surface.name) + ", zoom " + std::to_string(int(zoom)));
            const Status measured = measure(surface, zoom, records);
            if (!measured) {
                return measured;
            }
        }
        return Done{};
    }

    // The sums over all surfaces come last.
    void add_sums() {
        for (const auto& [zoom, measured] : sums_) {
            add_rows("all", zoom, measured);
        }
    }

    const ordered_json& rows() const { return rows_; }

private:
    Status measure(const GallerySurface& surface, double zoom, const Records& records) {
        std::vector<FrameCase> frames;
        for (int view = 0; view < settings_.views; ++view) {
            for (std::size_t i = 0; i < methods_.size(); ++i) {
                frames.push_back({methods_[i].name, records[i],
                                  camera_of(surface, zoom, view, settings_.views), size_,
                                  bench_options()});
            }
        }
        std::vector<Measured> measured(methods_.size());
        Status status = judge(surface, zoom, frames, measured);
        if (!status) {
            return status;
        }
        const Result<std::vector<Rounds>> timed = stage_.time(frames, settings_, 0.0);
        if (!timed) {
            return timed.error();
        }
        std::vector<Measured>& sums = sums_[zoom];
        sums.resize(methods_.size());
        for (std::size_t i = 0; i < frames.size(); ++i) {
            add({timed.value()[i], {}}, measured[i % methods_.size()]);
        }
        for (std::size_t i = 0; i < methods_.size(); ++i) {
            add(measured[i], sums[i]);
        }
        add_rows(surface.name, zoom, measured);
        return Done{};
    }

    Status judge(const GallerySurface& surface, double zoom, const std::vector<FrameCase>& frames,
                 std::vector<Measured>& measured) {
        const Crossings truth = crossings_of(float_terms(surface.polynomial), 1.0f);
        std::optional<Judge> judge;
        for (std::size_t i = 0; i < frames.size(); ++i) {
            const std::size_t method = i % methods_.size();
            if (method == 0) {
                judge.emplace(truth, make_view(frames[i].camera, size_), 1.0,
                              apart * pixel_size(zoom, size_) * size_.width);
            }
            if (methods_[method].solver == solver_none) {
                continue;
            }
            if (settings_.is_stopped()) {
                return Error{ErrorKind::interrupted, "", "interrupted"};
            }
            const Result<GBuffer> picture = stage_.inspect(frames[i]);
            if (!picture) {
                return picture.error();
            }
            add(judge->judge(picture.value()), measured[method].judgement);
        }
        return Done{};
    }

    void add_rows(std::string_view surface, double zoom, const std::vector<Measured>& measured) {
        const auto found = std::find_if(methods_.begin(), methods_.end(), [](const Method& method) {
            return method.name == "sturm";
        });
        const Measured& sturm = measured[static_cast<std::size_t>(found - methods_.begin())];
        const Rounds& none = measured.back().rounds;
        for (std::size_t i = 0; i < methods_.size(); ++i) {
            const Measured& one = measured[i];
            const double views = settings_.views;
            ordered_json row{{"surface", surface},
                             {"zoom", zoom},
                             {"method", methods_[i].name},
                             {"frame_ms", 1e3 * median(one.rounds) / views},
                             {"ratio_to_sturm", median_ratio(sturm.rounds, one.rounds)}};
            if (methods_[i].solver != solver_none) {
                const Judgement& judgement = one.judgement;
                row["solver_only_ratio_to_sturm"] =
                    median_ratio(sturm.rounds, one.rounds, none, none);
                row["wrong_hard"] =
                    judgement.missed.hard + judgement.false_hits.hard + judgement.elsewhere.hard;
                add_truth(judgement, "other", row);
            }
            row["pixel_size"] = pixel_size(zoom, size_);
            rows_.push_back(std::move(row));
        }
    }

    Stage& stage_;
    const BenchSettings& settings_;
    PixelSize size_;
    std::vector<Method> methods_;
    std::map<double, std::vector<Measured>> sums_;
    ordered_json rows_ = ordered_json::array();
};

Table rows_table(const ordered_json& rows) {
    Table table;
    table.key = "rows";
    table.columns = {{"surface", "surface", {}},
                     {"zoom", "zoom", {}},
                     {"method", "method", {}},
                     {"frame_ms", "ms", {}},
                     {"ratio_to_sturm", "x sturm", {}},
                     {"solver_only_ratio_to_sturm", "x solver only", {}},
                     {"wrong_hard", "", {}}};
    const std::vector<Column> truth = truth_columns("other");
    table.columns.insert(table.columns.end(), truth.begin(), truth.end());
    table.columns.push_back({"pixel_size", "", {}});
    table.rows = rows;
    return table;
}

// Wrong pixels of all surfaces together, as the view closes in on their singular points.
Plot plot_of(const ordered_json& rows, const std::string& title, const Conditions& conditions) {
    Plot plot;
    plot.title = title + ": hard wrong pixels per million true hits, by zoom";
    plot.caption = as_text(conditions) + "; none at all: no point";
    plot.x = {"zoom towards singular points", true};
    plot.y = {"missed, false or at another place, per million hits", true};
    for (const ordered_json& row : rows) {
        if (row["surface"] != "all" || !row.contains("wrong_hard")) {
            continue;
        }
        const std::string name = row["method"];
        auto series = std::find_if(plot.series.begin(), plot.series.end(),
                                   [&](const Series& one) { return one.name == name; });
        if (series == plot.series.end()) {
            series = plot.series.insert(series, {name, {}});
        }
        const double hits = std::max(1.0, row["true_hits"].get<double>());
        series->points.push_back({row["zoom"], 1e6 * row["wrong_hard"].get<double>() / hits});
    }
    return plot;
}

Result<Report> bench_surfaces(const BenchSettings& settings, int degree) {
    const std::string name = degree == 3 ? "cubic" : "quartic";
    const PixelSize size = settings.size.width > 0 ? settings.size : PixelSize{512, 512};
    Result<Stage> stage = Stage::open(settings.software);
    if (!stage) {
        return stage.error();
    }
    SurfaceBench bench(stage.value(), settings, size, name);
    for (const GallerySurface& surface : gallery()) {
        if (surface.degree == degree) {
            const Status measured = bench.measure(surface);
            if (!measured) {
                return measured.error();
            }
        }
    }
    bench.add_sums();
    Report report;
    report.bench = name + "s";
    report.conditions = stage.value().conditions(size, settings.rounds);
    report.tables = {rows_table(bench.rows())};
    report.notes = {
        "Each row is of " + std::to_string(settings.views) +
            " views; zoomed ones look at singular points, of which smooth surfaces have none.",
        "Errors are distances along the ray in halves of the cube's edge, against the roots in "
        "long double of the shader's own rays; other: hits farther apart than a hundredth of the "
        "picture's width. Hard: no ray within 0.01 pixels gives the solver's answer."};
    report.plot = plot_of(bench.rows(), degree == 3 ? "Cubics" : "Quartics", report.conditions);
    return report;
}

}  // namespace

Result<Report> bench_cubics(const BenchSettings& settings) {
    return bench_surfaces(settings, 3);
}

Result<Report> bench_quartics(const BenchSettings& settings) {
    return bench_surfaces(settings, 4);
}

}  // namespace quartic
