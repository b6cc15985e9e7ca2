// The benchmark one-torus: table 1 of de Toledo, Levy, Paul 2007 again, on this machine, with what
// each solver loses and how far it errs.
#include "bench/judge.h"
#include "bench/paper_table.h"
#include "bench/scenes.h"
#include "bench/stage.h"
#include "bench/truth_columns.h"
#include "solvers/solver_table.h"

#include <array>
#include <cmath>
#include <numbers>

namespace quartic {
namespace {

using nlohmann::ordered_json;

constexpr std::size_t angle_count = paper_angles_deg.size();
constexpr double measured_s = 0.03;  // of one frame in one round: short frames are repeated
constexpr double lobe_radii = 0.1;   // hits farther apart are on another lobe

// A column of the paper's table: a solver on a proxy, or a polygon.
struct Method {
    std::string name;
    std::string proxy;  // "box", "automatic", or empty for polygons
    int solver = 0;     // 0: a polygon
    int sides = 0;
    std::shared_ptr<const Packed> packed;
    std::array<Rounds, angle_count> rounds;
    std::array<Judgement, angle_count> judged;
    std::uint64_t gpu_bytes = 0;

    bool is_judged() const { return sides == 0 && solver != solver_none; }
};

using Methods = std::vector<Method>;

Methods make_methods() {
    Methods methods;
    const Scene ring = ring_scene();
    const auto add_solver = [&](const std::string& name, int solver, const std::string& proxy) {
        methods.push_back({name, proxy, solver, 0, pack_for(ring, solver), {}, {}, 0});
    };
    for (const SolverRow& row : solver_table()) {
        if (solves(row, "torus")) {
            add_solver(std::string(row.name), row.id, "box");
        }
    }
    add_solver("convexity_split_auto_proxy", solver_default, "automatic");
    add_solver("none", solver_none, "box");
    add_solver("none_auto_proxy", solver_none, "automatic");
    for (const int sides : {32, 64, 128, 256, 512}) {
        methods.push_back({"polygon_" + std::to_string(sides),
                           "",
                           0,
                           sides,
                           pack_for(polygon_ring_scene(sides), 0),
                           {},
                           {},
                           0});
    }
    return methods;
}

FrameCase frame_of(const Method& method, std::size_t angle, PixelSize size) {
    FrameCase frame;
    frame.name = method.name;
    frame.packed = method.packed;
    frame.camera = ring_camera(paper_angles_deg[angle]);
    frame.size = size;
    frame.options = bench_options();
    frame.options.proxy = method.proxy == "box" ? Proxy::box : Proxy::automatic;
    return frame;
}

Status time_all(Stage& stage, Methods& methods, PixelSize size, const BenchSettings& settings) {
    std::vector<FrameCase> frames;
    for (std::size_t angle = 0; angle < angle_count; ++angle) {
        for (const Method& method : methods) {
            frames.push_back(frame_of(method, angle, size));
        }
    }
    const Result<std::vector<Rounds>> timed = stage.time(frames, settings, measured_s);
    if (!timed) {
        return timed.error();
    }
    for (std::size_t i = 0; i < frames.size(); ++i) {
        methods[i % methods.size()].rounds[i / methods.size()] = timed.value()[i];
    }
    return Done{};
}

Status judge_all(Stage& stage, Methods& methods, PixelSize size, const BenchSettings& settings) {
    for (std::size_t angle = 0; angle < angle_count; ++angle) {
        settings.note("judging at " + std::to_string(paper_angles_deg[angle]) + " degrees");
        Judge judge(crossings_of(float_ring()),
                    make_view(ring_camera(paper_angles_deg[angle]), size), test_ring.radius,
                    lobe_radii * test_ring.radius);
        for (Method& method : methods) {
            if (settings.is_stopped()) {
                return Error{ErrorKind::interrupted, "", "interrupted"};
            }
            const FrameCase frame = frame_of(method, angle, size);
            const Result<GBuffer> picture = stage.inspect(frame);
            if (!picture) {
                return picture.error();
            }
            method.gpu_bytes = stage.gpu_bytes();
            if (method.sides == 0) {
                method.judged[angle] =
                    method.is_judged() ? judge.judge(picture.value()) : count_rays(picture.value());
            }
        }
    }
    return Done{};
}

const Method& find(const Methods& methods, std::string_view name) {
    for (const Method& method : methods) {
        if (method.name == name) {
            return method;
        }
    }
    return methods.front();
}

// The mean of the six frame rates, round by round: what the paper calls the average.
Rounds mean_fps(const Method& method) {
    Rounds mean(method.rounds[0].size(), 0.0);
    for (const Rounds& rounds : method.rounds) {
        for (std::size_t i = 0; i < mean.size(); ++i) {
            mean[i] += 1.0 / (rounds[i] * angle_count);
        }
    }
    return mean;
}

struct Spread {
    double mean = 0.0;
    double deviation = 0.0;
};

Spread spread_of(const std::array<double, angle_count>& values) {
    Spread spread;
    for (const double value : values) {
        spread.mean += value / angle_count;
    }
    for (const double value : values) {
        spread.deviation += (value - spread.mean) * (value - spread.mean) / (angle_count - 1);
    }
    spread.deviation = std::sqrt(spread.deviation);
    return spread;
}

void add_speed(const Methods& methods, const Method& method, ordered_json& row) {
    std::array<double, angle_count> fps{};
    std::array<double, angle_count> frame_ms{};
    std::array<double, angle_count> megapixels{};
    for (std::size_t i = 0; i < angle_count; ++i) {
        const double seconds = median(method.rounds[i]);
        fps[i] = 1.0 / seconds;
        frame_ms[i] = 1e3 * seconds;
        megapixels[i] = 1e-6 * static_cast<double>(method.judged[i].covered) * fps[i];
    }
    row["fps"] = fps;
    row["frame_ms"] = frame_ms;
    row["fps_mean"] = median(mean_fps(method));
    const Method& newton = find(methods, "newton");
    row["ratio_to_newton"] = median_ratio(mean_fps(method), mean_fps(newton));
    row["solver_only_ratio_to_newton"] = nullptr;
    if (method.is_judged()) {
        const bool box = method.proxy == "box";
        const double ratio = median_ratio(
            sum_of(newton.rounds), sum_of(method.rounds), sum_of(find(methods, "none").rounds),
            sum_of(find(methods, box ? "none" : "none_auto_proxy").rounds));
        row["solver_only_ratio_to_newton"] = ratio > 0.0 ? ordered_json(ratio) : ordered_json();
    }
    if (method.sides == 0) {
        const Spread spread = spread_of(megapixels);
        row["megapixels_per_second"] = spread.mean;
        row["megapixels_stddev"] = spread.deviation;
        row["megapixels_stddev_pct"] = 100.0 * spread.deviation / spread.mean;
    }
}

void add_pixels(const Method& method, ordered_json& row) {
    std::array<double, angle_count> waste{};
    std::array<std::uint64_t, angle_count> covered{};
    std::array<std::uint64_t, angle_count> hits{};
    std::array<std::uint64_t, angle_count> missed{};
    for (std::size_t i = 0; i < angle_count; ++i) {
        waste[i] = method.judged[i].waste();
        covered[i] = method.judged[i].covered;
        hits[i] = method.judged[i].hits;
        missed[i] = method.judged[i].missed.hard;
    }
    row["waste"] = waste;
    row["bbox_pixels"] = covered;
    row["torus_pixels"] = hits;
    row["missed_hard_by_angle"] = missed;
}

void add_judgement(const Method& method, ordered_json& row) {
    Judgement sum;
    for (const Judgement& judged : method.judged) {
        add(judged, sum);
    }
    add_truth(sum, "wrong_lobe", row);
    row["epsilon_r"] = row["error_max"];
    row["epsilon_total"] = row["error_max"].get<double>() * test_ring.radius;  // R + r = 1
}

void add_paper(const Method& method, ordered_json& row) {
    for (const PaperRow& paper : paper_rows) {
        if (paper.method == method.name) {
            row["paper_method"] = paper.name;
            row["paper_fps"] = paper.fps;
            row["paper_fps_mean"] = paper.fps_mean;
            row["paper_ratio_to_newton"] = paper.fps_mean / paper_rows[5].fps_mean;
            row["paper_epsilon_r"] = 1e-6 * paper.error_micro_r;
            row["paper_epsilon_total"] = 1e-6 * paper.error_micro_total;
            if (paper.megapixels_per_second > 0.0) {
                row["paper_megapixels_per_second"] = paper.megapixels_per_second;
                row["paper_megapixels_stddev_pct"] = paper.megapixels_stddev_pct;
            }
        }
    }
}

ordered_json row_of(const Methods& methods, const Method& method) {
    ordered_json row{{"method", method.name}, {"proxy", method.proxy}};
    add_speed(methods, method, row);
    if (method.is_judged()) {
        add_pixels(method, row);
        add_judgement(method, row);
    }
    if (method.sides > 0) {
        // The paper's formula: how far chords pass inside a circle.
        const double epsilon = 1.0 - std::cos(std::numbers::pi / method.sides);
        row["epsilon_r"] = epsilon / test_ring.radius;
        row["epsilon_total"] = epsilon;
    }
    row["gpu_bytes"] = method.gpu_bytes;
    add_paper(method, row);
    return row;
}

std::vector<std::string> angle_names() {
    std::vector<std::string> names;
    for (const int angle : paper_angles_deg) {
        names.push_back(std::to_string(angle) + "deg");
    }
    return names;
}

Table rows_table(const Methods& methods) {
    const std::vector<std::string> angles = angle_names();
    Table table;
    table.key = "rows";
    table.columns = {{"method", "method", {}},
                     {"proxy", "proxy", {}},
                     {"fps", "", angles},
                     {"frame_ms", "", angles},
                     {"fps_mean", "fps", {}},
                     {"ratio_to_newton", "x newton", {}},
                     {"solver_only_ratio_to_newton", "x solver only", {}},
                     {"waste", "", angles},
                     {"bbox_pixels", "", angles},
                     {"torus_pixels", "", angles},
                     {"missed_hard_by_angle", "", angles}};
    const std::vector<Column> truth = truth_columns("wrong_lobe");
    table.columns.insert(table.columns.end(), truth.begin(), truth.end());
    for (const char* key : {"epsilon_r", "epsilon_total", "megapixels_per_second",
                            "megapixels_stddev", "megapixels_stddev_pct", "gpu_bytes"}) {
        table.columns.push_back({key, "", {}});
    }
    for (const Method& method : methods) {
        table.rows.push_back(row_of(methods, method));
    }
    return table;
}

Table beside_paper(const ordered_json& rows) {
    Table table;
    table.title = "Beside table 1 of de Toledo, Levy, Paul 2007 (GeForce 7900)";
    table.columns = {{"method", "method", {}},
                     {"fps", "fps", angle_names()},
                     {"fps_mean", "mean", {}},
                     {"paper_fps_mean", "paper's mean", {}},
                     {"ratio_to_newton", "x newton", {}},
                     {"paper_ratio_to_newton", "paper's", {}},
                     {"epsilon_r", "eps(r)", {}},
                     {"epsilon_total", "eps(R+r)", {}},
                     {"paper_epsilon_r", "paper's eps(r)", {}},
                     {"megapixels_per_second", "Mpx/s", {}},
                     {"megapixels_stddev_pct", "stddev %", {}},
                     {"paper_megapixels_per_second", "paper's Mpx/s", {}},
                     {"paper_megapixels_stddev_pct", "stddev %", {}},
                     {"gpu_bytes", "bytes", {}}};
    table.rows = rows;
    return table;
}

Table views_table(const Methods& methods) {
    Table table;
    table.key = "views";
    table.title = "Pixels of the box and of the ring";
    table.columns = {{"angle_deg", "angle", {}},
                     {"bbox_pixels", "box", {}},
                     {"paper_bbox_pixels", "paper's", {}},
                     {"torus_pixels", "ring", {}},
                     {"paper_torus_pixels", "paper's", {}},
                     {"waste_pct", "waste %", {}},
                     {"paper_waste_pct", "paper's", {}},
                     {"auto_proxy_waste_pct", "automatic proxy", {}}};
    const Method& box = find(methods, "newton");
    const Method& automatic = find(methods, "convexity_split_auto_proxy");
    for (std::size_t i = 0; i < angle_count; ++i) {
        table.rows.push_back({{"angle_deg", paper_angles_deg[i]},
                              {"bbox_pixels", box.judged[i].covered},
                              {"paper_bbox_pixels", std::lround(1e3 * paper_box_kilopixels[i])},
                              {"torus_pixels", box.judged[i].hits},
                              {"paper_torus_pixels", std::lround(1e3 * paper_torus_kilopixels[i])},
                              {"waste_pct", 100.0 * box.judged[i].waste()},
                              {"paper_waste_pct", paper_waste_pct[i]},
                              {"auto_proxy_waste_pct", 100.0 * automatic.judged[i].waste()}});
    }
    return table;
}

Plot plot_of(const ordered_json& rows, const Conditions& conditions) {
    Plot plot;
    plot.title = "One torus: speed relative to bounded Newton as printed, on the box";
    plot.caption = as_text(conditions);
    plot.x.label = "times as fast as newton (mean of six views)";
    plot.series = {{"frame", {}}, {"solver only", {}}, {"paper (GeForce 7900)", {}}};
    for (const ordered_json& row : rows) {
        const double y = static_cast<double>(plot.categories.size());
        plot.categories.push_back(row["method"]);
        std::size_t series = 0;
        for (const char* key :
             {"ratio_to_newton", "solver_only_ratio_to_newton", "paper_ratio_to_newton"}) {
            if (row.contains(key) && row[key].is_number()) {
                plot.series[series].points.push_back({row[key], y});
            }
            ++series;
        }
    }
    return plot;
}

}  // namespace

Result<Report> bench_one_torus(const BenchSettings& settings) {
    const PixelSize size = settings.size.width > 0 ? settings.size : PixelSize{1024, 1024};
    Result<Stage> stage = Stage::open(settings.software);
    if (!stage) {
        return stage.error();
    }
    Methods methods = make_methods();
    Status status = judge_all(stage.value(), methods, size, settings);
    if (status) {
        settings.note("timing " + std::to_string(settings.rounds) + " rounds");
        status = time_all(stage.value(), methods, size, settings);
    }
    if (!status) {
        return status.error();
    }
    Report report;
    report.bench = "one-torus";
    report.conditions = stage.value().conditions(size, settings.rounds);
    report.tables.push_back(rows_table(methods));
    const ordered_json rows = report.tables[0].rows;
    report.tables.push_back(beside_paper(rows));
    report.tables.push_back(views_table(methods));
    report.notes = {
        "Ratios are medians of the rounds' ratios. Solver only: frame time less that of the method "
        "none, which does everything but solve, on the same proxy. Errors are distances along the "
        "ray in radii of the tube, against the roots in long double of the shader's own rays.",
        "eps is the largest such error; of polygons 1 - cos(pi / N), as in the paper. Its eps(R+r) "
        "is eps(r) times 3/7; here it is times 3/10, since R + r = 1."};
    report.plot = plot_of(rows, report.conditions);
    return report;
}

}  // namespace quartic
