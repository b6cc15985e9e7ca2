// The benchmark proxies: how many rays each proxy wastes, how long pictures full of parts of each
// size take with it, and whether the automatic choice is right.
#include "bench/judge.h"
#include "bench/proxy_shapes.h"
#include "bench/stage.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace quartic {
namespace {

using nlohmann::ordered_json;

constexpr int diameters_px[] = {8, 16, 32, 64, 128, 256, 512};
constexpr double waste_distance = 4.6;  // of the eye, in radii
// Distances at which pictures of the proxies are compared.
constexpr double nearest = 2.6;
constexpr double farthest = 50.0;
constexpr double measured_s = 0.05;
constexpr double right_ratio = 1.05;  // the choice is right if the fastest is no faster than this

struct Candidate {
    const char* name;
    Proxy proxy;
};
// Whatever the proxies are compared with stands first, the choice between them last.
constexpr std::array<Candidate, 4> candidates{{{"box", Proxy::box},
                                               {"quad", Proxy::quad},
                                               {"hull", Proxy::hull},
                                               {"automatic", Proxy::automatic}}};
constexpr std::size_t quad = 1;
constexpr std::size_t hull = 2;
constexpr std::size_t automatic = 3;

// The same frame with every proxy.
std::vector<FrameCase> frames_of(const std::shared_ptr<const Packed>& packed, const Camera& camera,
                                 PixelSize size) {
    std::vector<FrameCase> frames;
    for (const Candidate& candidate : candidates) {
        frames.push_back({candidate.name, packed, camera, size, bench_options()});
        frames.back().options.proxy = candidate.proxy;
    }
    return frames;
}

struct Waste {
    double sum = 0.0;  // over the views
    std::uint64_t lost = 0;
    std::uint64_t gained = 0;
    std::uint64_t compared = 0;  // pixels that the box shows
};

std::uint64_t hits_of(const GBuffer& picture) {
    return static_cast<std::uint64_t>(std::count_if(picture.ids.begin(), picture.ids.end(),
                                                    [](auto id) { return id != no_index; }));
}

void compare(const GBuffer& box, const GBuffer& other, Waste& into) {
    for (std::size_t i = 0; i < box.ids.size(); ++i) {
        const bool is_in_box = box.ids[i] != no_index;
        const bool is_in_other = other.ids[i] != no_index;
        into.compared += is_in_box;
        into.lost += is_in_box && !is_in_other;
        into.gained += is_in_other && !is_in_box;
    }
}

// Frame times of all shapes together.
struct TimesOfSize {
    std::array<Rounds, candidates.size()> rounds;
    double seen_px = 0.0;
    int shapes = 0;
};

class ProxyBench {
public:
    ProxyBench(Stage& stage, const BenchSettings& settings, PixelSize size)
        : stage_(stage), settings_(settings), size_(size) {}

    Status measure(const ProxyShape& shape) {
        settings_.note(shape.name + ", waste");
        Status status = measure_waste(shape);
        for (const int diameter_px : diameters_px) {
            if (status && 2 * diameter_px <= size_.height) {
                settings_.note(shape.name + ", " + std::to_string(diameter_px) + " pixels");
                status = measure_times(shape, diameter_px);
            }
        }
        add_crossover(shape.name);
        return status;
    }

    // The sums over all shapes come last.
    void add_sums() {
        for (const auto& [diameter_px, sum] : sums_) {
            const std::vector<Rounds> rounds(sum.rounds.begin(), sum.rounds.end());
            add_times("all", diameter_px, sum.seen_px / sum.shapes, rounds);
        }
        add_crossover("all");
    }

    const ordered_json& waste_rows() const { return waste_rows_; }
    const ordered_json& time_rows() const { return time_rows_; }
    const ordered_json& crossovers() const { return crossovers_; }

private:
    Status measure_waste(const ProxyShape& shape) {
        const PixelSize size{std::max(1, size_.width / 2), std::max(1, size_.height / 2)};
        const auto packed = pack_for(shape.scene, 0);
        std::array<Waste, candidates.size()> wastes;
        for (int view = 0; view < settings_.views; ++view) {
            if (settings_.is_stopped()) {
                return Error{ErrorKind::interrupted, "", "interrupted"};
            }
            Status status = count_rays_of(
                frames_of(packed, random_camera(shape, view, waste_distance), size), wastes);
            status = status ? compare_view(shape, view, packed, size, wastes) : status;
            if (!status) {
                return status;
            }
        }
        for (std::size_t i = 0; i < candidates.size(); ++i) {
            waste_rows_.push_back({{"shape", shape.name},
                                   {"proxy", candidates[i].name},
                                   {"waste", wastes[i].sum / settings_.views},
                                   {"lost", wastes[i].lost},
                                   {"gained", wastes[i].gained},
                                   {"compared_pixels", wastes[i].compared}});
        }
        return Done{};
    }

    Status count_rays_of(const std::vector<FrameCase>& frames,
                         std::array<Waste, candidates.size()>& wastes) {
        for (std::size_t i = 0; i < frames.size(); ++i) {
            const Result<GBuffer> picture = stage_.inspect(frames[i]);
            if (!picture) {
                return picture.error();
            }
            const auto hits = static_cast<double>(hits_of(picture.value()));
            const auto rays = static_cast<double>(count_rays(picture.value()).rays);
            wastes[i].sum += rays > 0.0 ? 1.0 - hits / rays : 0.0;
        }
        return Done{};
    }

    // Zoomed in until the shape fills the picture, every fifth view with parallel rays.
    Status compare_view(const ProxyShape& shape, int view,
                        const std::shared_ptr<const Packed>& packed, PixelSize size,
                        std::array<Waste, candidates.size()>& wastes) {
        const double part = view / std::max(1.0, settings_.views - 1.0);
        Camera camera = random_camera(shape, view, nearest * std::pow(farthest / nearest, part));
        zoom_to(shape, camera);
        camera.projection = view % 5 == 4 ? Projection::orthographic : Projection::perspective;
        const std::vector<FrameCase> frames = frames_of(packed, camera, size);
        const Result<GBuffer> box = stage_.draw(frames[0]);
        if (!box) {
            return box.error();
        }
        for (std::size_t i = 0; i < frames.size(); ++i) {
            const Result<GBuffer> other = stage_.draw(frames[i]);
            if (!other) {
                return other.error();
            }
            compare(box.value(), other.value(), wastes[i]);
        }
        return Done{};
    }

    Status measure_times(const ProxyShape& shape, int diameter_px) {
        const ProxyGrid grid = make_proxy_grid(shape, diameter_px, size_);
        const std::vector<FrameCase> frames =
            frames_of(pack_for(grid.scene, 0), grid.camera, size_);
        const Result<std::vector<Rounds>> timed = stage_.time(frames, settings_, measured_s);
        if (!timed) {
            return timed.error();
        }
        const Result<std::string> chosen = choice_of(frames);
        if (!chosen) {
            return chosen.error();
        }
        add_times(shape.name, diameter_px, grid.seen_px, timed.value());
        ordered_json& row = time_rows_.back();
        row["chosen"] = chosen.value();
        // Then both times are of the same work, and differ by chance.
        row["right"] = row["right"] || row["chosen"] == row["fastest"];
        TimesOfSize& sum = sums_[diameter_px];
        for (std::size_t i = 0; i < candidates.size(); ++i) {
            const Rounds& rounds = timed.value()[i];
            sum.rounds[i] = sum.shapes == 0 ? rounds : sum_of({{sum.rounds[i], rounds}});
        }
        sum.seen_px += grid.seen_px;
        ++sum.shapes;
        return Done{};
    }

    // The automatic choice costs as many rays as the proxy that it takes.
    Result<std::string> choice_of(const std::vector<FrameCase>& frames) {
        std::array<std::uint64_t, candidates.size()> rays{};
        for (const std::size_t i : {quad, hull, automatic}) {
            const Result<GBuffer> picture = stage_.inspect(frames[i]);
            if (!picture) {
                return picture.error();
            }
            rays[i] = count_rays(picture.value()).rays;
        }
        return std::string(rays[automatic] == rays[quad]   ? "quad"
                           : rays[automatic] == rays[hull] ? "hull"
                                                           : "both");
    }

    void add_times(const std::string& shape, int diameter_px, double seen_px,
                   const std::vector<Rounds>& rounds) {
        const auto fastest =
            static_cast<std::size_t>(std::min_element(rounds.begin(), rounds.begin() + automatic,
                                                      [](const Rounds& a, const Rounds& b) {
                                                          return median(a) < median(b);
                                                      }) -
                                     rounds.begin());
        ordered_json frame_ms = ordered_json::array();
        for (const Rounds& of_proxy : rounds) {
            frame_ms.push_back(1e3 * median(of_proxy));
        }
        const double behind = median_ratio(rounds[automatic], rounds[fastest]);
        time_rows_.push_back({{"shape", shape},
                              {"size_px", diameter_px},
                              {"seen_px", seen_px},
                              {"frame_ms", frame_ms},
                              {"fastest", candidates[fastest].name},
                              {"chosen", nullptr},
                              {"fastest_ratio_to_automatic", behind},
                              {"right", behind <= right_ratio}});
    }

    void add_crossover(const std::string& shape) {
        std::vector<double> sizes;
        std::vector<double> quads;
        std::vector<double> hulls;
        for (const ordered_json& row : time_rows_) {
            if (row["shape"] == shape) {
                sizes.push_back(row["seen_px"]);
                quads.push_back(row["frame_ms"][quad]);
                hulls.push_back(row["frame_ms"][hull]);
            }
        }
        const std::optional<double> found = crossover(sizes, hulls, quads);
        crossovers_.push_back(
            {{"shape", shape}, {"seen_px", found ? ordered_json(*found) : ordered_json()}});
    }

    Stage& stage_;
    const BenchSettings& settings_;
    PixelSize size_;
    ordered_json waste_rows_ = ordered_json::array();
    ordered_json time_rows_ = ordered_json::array();
    ordered_json crossovers_ = ordered_json::array();
    std::map<int, TimesOfSize> sums_;
};

std::vector<Table> tables_of(const ProxyBench& bench) {
    Table waste{"rows", "", {}, bench.waste_rows()};
    waste.columns = {{"shape", "shape", {}},   {"proxy", "proxy", {}},
                     {"waste", "waste", {}},   {"lost", "lost", {}},
                     {"gained", "gained", {}}, {"compared_pixels", "of pixels", {}}};
    Table times{"times", "Frame times in milliseconds", {}, bench.time_rows()};
    std::vector<std::string> names;
    for (const Candidate& candidate : candidates) {
        names.emplace_back(candidate.name);
    }
    times.columns = {{"shape", "shape", {}},
                     {"size_px", "px", {}},
                     {"seen_px", "seen px", {}},
                     {"frame_ms", "ms", names},
                     {"fastest", "fastest", {}},
                     {"chosen", "chosen", {}},
                     {"fastest_ratio_to_automatic", "x automatic", {}},
                     {"right", "right", {}}};
    Table crossovers{
        "crossovers", "From which size on hulls are faster than quads", {}, bench.crossovers()};
    crossovers.columns = {{"shape", "shape", {}}, {"seen_px", "seen px", {}}};
    return {waste, times, crossovers};
}

Plot plot_of(const ordered_json& times, const Conditions& conditions) {
    Plot plot;
    plot.title = "Proxies: frame time over size, sum of all shapes";
    plot.caption = as_text(conditions);
    plot.x = {"diameter of the sphere around a part, in pixels", true};
    plot.y = {"milliseconds", true};
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        Series& series = plot.series.emplace_back();
        series.name = candidates[i].name;
        for (const ordered_json& row : times) {
            if (row["shape"] == "all") {
                series.points.push_back({row["size_px"], row["frame_ms"][i]});
            }
        }
    }
    return plot;
}

}  // namespace

Result<Report> bench_proxies(const BenchSettings& settings) {
    const PixelSize size = settings.size.width > 0 ? settings.size : PixelSize{1024, 1024};
    Result<Stage> stage = Stage::open(settings.software);
    if (!stage) {
        return stage.error();
    }
    ProxyBench bench(stage.value(), settings, size);
    for (const ProxyShape& shape : make_proxy_shapes()) {
        const Status measured = bench.measure(shape);
        if (!measured) {
            return measured.error();
        }
    }
    bench.add_sums();
    Report report;
    report.bench = "proxies";
    report.conditions = stage.value().conditions(size, settings.rounds);
    report.tables = tables_of(bench);
    report.notes = {
        "Waste: mean of " + std::to_string(settings.views) +
            " random views, 4.6 radii away, 30 degrees, half the size. Lost and gained: pixels "
            "against the picture of the box, in as many views from 2.6 to 50 radii.",
        "px: diameter of the sphere around a part. seen px: the size by which the choice is made. "
        "right: the fastest is what was chosen, or no more than 5 % faster."};
    report.plot = plot_of(bench.time_rows(), report.conditions);
    return report;
}

}  // namespace quartic
