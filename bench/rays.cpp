// The benchmark rays: the default solver on as many random rays as there is time for.
#include "bench/benches.h"
#include "bench/random_rays.h"
#include "solvers/solver_table.h"

namespace quartic {
namespace {

using nlohmann::ordered_json;

struct Group {
    std::string name;
    double ratio;
    bool arcs;
};

ordered_json row_of(const Group& group, RayKind kind, const RayTrial& trial) {
    ordered_json row;
    row["method"] = solver_table()[0].name;
    row["tori"] = group.name;
    row["kind"] = name(kind);
    row["rays"] = trial.rays;
    row["true_hits"] = trial.hits;
    row["missed_hard"] = trial.missed_hard;
    row["false_hard"] = trial.false_hard;
    row["wrong_lobe_hard"] = trial.elsewhere_hard;
    row["ties"] = trial.ties;
    row["error_median"] = trial.errors.quantile(0.5);
    row["error_p9999"] = trial.errors.quantile(0.9999);
    row["error_max"] = trial.errors.most();
    row["iterations_mean"] = static_cast<double>(trial.steps) /
                             static_cast<double>(std::max<std::uint64_t>(trial.rays, 1));
    row["iterations_max"] = trial.steps_max;
    return row;
}

}  // namespace

Result<Report> bench_rays(const BenchSettings& settings) {
    const Group groups[] = {{"rings, r/R 0.05 to 5", 0.0, false},
                            {"elbows, r/R 0.05 to 1, 1 to 359 degrees", 0.0, true},
                            {"rings, r/R 3/7", 3.0 / 7.0, false}};
    Report report;
    report.bench = "rays";
    report.conditions.rounds = 1;
    Table& table = report.tables.emplace_back();
    table.key = "rows";
    table.columns = {{"method", "", {}},
                     {"tori", "tori", {}},
                     {"kind", "rays", {}},
                     {"rays", "count", {}},
                     {"true_hits", "true hits", {}},
                     {"missed_hard", "missed hard", {}},
                     {"false_hard", "false hard", {}},
                     {"wrong_lobe_hard", "wrong lobe hard", {}},
                     {"ties", "ties", {}},
                     {"error_median", "error/r median", {}},
                     {"error_p9999", "99.99 %", {}},
                     {"error_max", "max", {}},
                     {"iterations_mean", "steps", {}},
                     {"iterations_max", "most", {}}};
    constexpr std::uint64_t row_count = std::size(groups) * ray_kind_count;
    for (const Group& group : groups) {
        for (std::size_t kind = 0; kind < ray_kind_count; ++kind) {
            RayTrialOptions options;
            options.rays = (settings.rays + row_count - 1) / row_count;
            options.kind = static_cast<RayKind>(kind);
            options.ratio = group.ratio;
            options.arcs = group.arcs;
            options.solver = solver_default;
            options.is_stopped = settings.is_stopped;
            settings.note(group.name + ": " + std::string(name(options.kind)));
            table.rows.push_back(row_of(group, options.kind, try_rays(options)));
        }
    }
    report.notes.push_back(
        "Every ray is float, as shaders get it, and judged by all its true roots in long double. A "
        "wrong answer is a tie where a ray a hundredth of a pixel aside, of pixels 1024 of which "
        "span the torus, makes it true.");
    return report;
}

}  // namespace quartic
