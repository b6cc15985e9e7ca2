// The benchmark many-tori: figure 6 of de Toledo, Levy, Paul 2007: frame times over the number of
// rings, rays against polygons.
#include "bench/scenes.h"
#include "bench/stage.h"
#include "solvers/solver_table.h"

#include <cmath>
#include <optional>

namespace quartic {
namespace {

using nlohmann::ordered_json;

constexpr double frame_s_max = 3.0;  // a method that needs longer is left out of larger counts
constexpr double measured_s = 0.05;

struct Method {
    std::string name;
    std::string proxy;
    int solver = 0;
    int sides = 0;
    bool stopped = false;
    std::vector<double> counts;  // of the rows
    std::vector<double> frame_s;
};

std::vector<Method> make_methods() {
    const auto rays = [](const char* name, const char* solver, const char* proxy) {
        return Method{name, proxy, find_solver(solver)->id, 0, false, {}, {}};
    };
    std::vector<Method> methods = {
        rays("newton", "newton", "box"), rays("newton_fine", "newton_fine", "box"),
        rays("convexity_split", "convexity_split", "box"),
        rays("convexity_split_auto_proxy", "convexity_split", "automatic")};
    for (const int sides : {32, 64, 128}) {
        methods.push_back({"polygon_" + std::to_string(sides), "", 0, sides, false, {}, {}});
    }
    return methods;
}

// The frames of one count; methods that were stopped have none.
Status measure(Stage& stage, std::vector<Method>& methods, std::uint64_t count, PixelSize size,
               const BenchSettings& settings, ordered_json& rows) {
    std::vector<FrameCase> frames;
    std::vector<Method*> drawn;
    for (Method& method : methods) {
        if (method.stopped) {
            continue;
        }
        FrameCase& frame = frames.emplace_back();
        frame = {method.name, pack_for(ring_grid_scene(count, method.sides), method.solver),
                 ring_grid_camera(count), size, bench_options()};
        frame.options.proxy = method.proxy == "box" ? Proxy::box : Proxy::automatic;
        drawn.push_back(&method);
    }
    const Result<std::vector<Rounds>> timed = stage.time(frames, settings, measured_s);
    if (!timed) {
        return timed.error();
    }
    const Rounds& newton = timed.value()[0];
    for (std::size_t i = 0; i < drawn.size(); ++i) {
        Method& method = *drawn[i];
        const Rounds& rounds = timed.value()[i];
        const double seconds = median(rounds);
        method.counts.push_back(static_cast<double>(count));
        method.frame_s.push_back(seconds);
        method.stopped = seconds > frame_s_max;
        rows.push_back({{"method", method.name},
                        {"proxy", method.proxy},
                        {"count", count},
                        {"frame_ms", 1e3 * seconds},
                        {"fps", 1.0 / seconds},
                        {"ratio_to_newton", median_ratio(newton, rounds)},
                        {"tori_per_second", static_cast<double>(count) / seconds},
                        {"record_bytes", frames[i].packed->batches[0].records.size()}});
    }
    return Done{};
}

Table crossover_table(const std::vector<Method>& methods) {
    Table table;
    table.key = "crossovers";
    table.title = "From how many tori a solver is faster than polygons";
    table.columns = {{"method", "method", {}}, {"than", "than", {}}, {"count", "tori", {}}};
    for (const Method& method : methods) {
        for (const Method& polygon : methods) {
            if (method.sides == 0 && polygon.sides > 0) {
                const std::optional<double> count =
                    crossover(method.counts, method.frame_s, polygon.frame_s);
                table.rows.push_back({{"method", method.name},
                                      {"than", polygon.name},
                                      {"count", count ? ordered_json(*count) : ordered_json()}});
            }
        }
    }
    return table;
}

// Frame times by count, a column for each method: what figure 6 shows.
Table overview(const std::vector<Method>& methods) {
    Table table;
    table.title = "Frame times in milliseconds";
    table.columns = {{"count", "tori", {}}};
    for (const Method& method : methods) {
        table.columns.push_back({method.name, method.name, {}});
        for (std::size_t i = 0; i < method.counts.size(); ++i) {
            while (table.rows.size() <= i) {
                table.rows.push_back(ordered_json::object());
            }
            table.rows[i]["count"] = static_cast<std::uint64_t>(method.counts[i]);
            table.rows[i][method.name] = 1e3 * method.frame_s[i];
        }
    }
    return table;
}

Plot plot_of(const std::vector<Method>& methods, const Conditions& conditions) {
    Plot plot;
    plot.title = "Many tori: frame rate over their number";
    plot.caption = as_text(conditions);
    plot.x = {"tori", true};
    plot.y = {"frames a second", true};
    for (const Method& method : methods) {
        Series& series = plot.series.emplace_back();
        series.name = method.name;
        for (std::size_t i = 0; i < method.counts.size(); ++i) {
            series.points.push_back({method.counts[i], 1.0 / method.frame_s[i]});
        }
    }
    return plot;
}

}  // namespace

Result<Report> bench_many_tori(const BenchSettings& settings) {
    const PixelSize size = settings.size.width > 0 ? settings.size : PixelSize{1024, 1024};
    Result<Stage> stage = Stage::open(settings.software);
    if (!stage) {
        return stage.error();
    }
    std::vector<Method> methods = make_methods();
    Report report;
    report.bench = "many-tori";
    report.conditions = stage.value().conditions(size, settings.rounds);
    Table rows;
    rows.key = "rows";
    rows.columns = {{"method", "method", {}},
                    {"proxy", "proxy", {}},
                    {"count", "tori", {}},
                    {"frame_ms", "ms", {}},
                    {"fps", "fps", {}},
                    {"ratio_to_newton", "x newton", {}},
                    {"tori_per_second", "tori/s", {}},
                    {"record_bytes", "bytes", {}}};
    for (std::uint64_t count = 1; count <= settings.count_max; count *= 4) {
        settings.note(std::to_string(count) + " tori");
        const Status measured = measure(stage.value(), methods, count, size, settings, rows.rows);
        if (!measured) {
            return measured.error();
        }
        for (const Method& method : methods) {
            if (method.stopped && method.counts.back() == static_cast<double>(count)) {
                report.notes.push_back(method.name + " stops at " + std::to_string(count) +
                                       " tori: a frame took longer than 3 s.");
            }
        }
        if (methods[0].stopped) {
            break;
        }
    }
    report.tables = {rows, overview(methods), crossover_table(methods)};
    report.notes.push_back(
        "Rings of R : r = 7 : 3 with random axes in a grid that fills the picture.");
    report.plot = plot_of(methods, report.conditions);
    return report;
}

}  // namespace quartic
