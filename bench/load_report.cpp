// The benchmark load: how fast models are decoded and become scenes.
#include "bench/benches.h"
#include "bench/load.h"
#include "bench/timing.h"
#include "exporters/rvm.h"
#include "files/output.h"
#include "generators/generate.h"

#include <utility>

namespace quartic {
namespace {

using nlohmann::ordered_json;

ordered_json load_row(const std::string& method, const Source& model, const LoadFigures& figures,
                      const std::vector<double>& seconds) {
    const double middle = median(seconds);
    return {{"method", method},
            {"file", model.path()},
            {"bytes", figures.bytes},
            {"parts", figures.parts},
            {"cores", method == "parse" ? 1 : figures.thread_count},
            {"median_s", middle},
            {"megabytes_per_second", 1e-6 * static_cast<double>(figures.bytes) / middle},
            {"parts_per_second", static_cast<double>(figures.parts) / middle},
            {"rounds_s", seconds}};
}

Result<Source> open_repeated(const std::string& path, int copies) {
    Result<Source> source = Source::open(path);
    if (!source || copies == 1) {
        return source;
    }
    return repeat_rvm(source.value(), static_cast<std::size_t>(copies));
}

// What is measured where no file is named: a plant that every machine makes alike.
Result<Source> make_sample() {
    constexpr std::uint64_t sample_parts = 1'000'000;
    const Result<Scene> plant = generate("plant", {sample_parts, 1, 0.0, {}});
    if (!plant) {
        return plant.error();
    }
    std::vector<std::byte> bytes;
    Output output = Output::to_memory(bytes);
    Status written = export_rvm(plant.value(), output);
    written = written ? output.commit() : written;
    if (!written) {
        return written.error();
    }
    return Source::from_bytes("generated plant", std::move(bytes));
}

Result<std::vector<Source>> load_models(const BenchSettings& settings) {
    std::vector<Source> models;
    for (const std::string& path : settings.files) {
        Result<Source> model = open_repeated(path, settings.copies);
        if (!model) {
            return model.error();
        }
        models.push_back(std::move(model).value());
    }
    if (models.empty()) {
        Result<Source> model = make_sample();
        if (!model) {
            return model.error();
        }
        models.push_back(std::move(model).value());
    }
    return models;
}

Plot plot_of(const ordered_json& rows, const Conditions& conditions) {
    Plot plot;
    plot.title = "Loading models";
    plot.caption = as_text(conditions);
    plot.x.label = "megabytes a second";
    plot.series.push_back({"speed", {}});
    for (const ordered_json& row : rows) {
        plot.series[0].points.push_back(
            {row["megabytes_per_second"], static_cast<double>(plot.categories.size())});
        plot.categories.push_back(row["file"].get<std::string>() + ", " +
                                  row["method"].get<std::string>());
    }
    return plot;
}

}  // namespace

// Two rows for each file: the parser alone where it can be had, and all of the loading.
Result<Report> bench_load(const BenchSettings& settings) {
    const Result<std::vector<Source>> models = load_models(settings);
    if (!models) {
        return models.error();
    }
    Report report;
    report.bench = "load";
    report.conditions.rounds = settings.rounds;
    Table table;
    table.key = "rows";
    table.columns = {{"method", "method", {}},
                     {"file", "file", {}},
                     {"bytes", "bytes", {}},
                     {"parts", "parts", {}},
                     {"cores", "cores", {}},
                     {"median_s", "median s", {}},
                     {"megabytes_per_second", "MB/s", {}},
                     {"parts_per_second", "parts/s", {}}};
    for (const Source& model : models.value()) {
        const Result<LoadFigures> measured = measure_load(model, settings.rounds, settings.threads);
        if (!measured) {
            return measured.error();
        }
        const LoadFigures& figures = measured.value();
        if (!figures.parse_s.empty()) {
            table.rows.push_back(load_row("parse", model, figures, figures.parse_s));
        }
        table.rows.push_back(load_row("scene", model, figures, figures.scene_s));
    }
    report.plot = plot_of(table.rows, report.conditions);
    report.tables.push_back(std::move(table));
    return report;
}

}  // namespace quartic
