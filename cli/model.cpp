// Loads models and shows how far they are.
#include "cli/model.h"

#include "cli/signals.h"
#include "exporters/rvm.h"
#include "exporters/save.h"
#include "importers/load.h"

#include <unistd.h>

#include <cstdio>
#include <utility>

namespace quartic::cli {
namespace {

constexpr int bar_width = 40;

enum class Display { none, bar, json };

Display chosen_display(const Reporting& reporting) {
    if (reporting.progress == "json") {
        return Display::json;
    }
    const bool terminal = ::isatty(STDERR_FILENO) == 1;
    return terminal && !reporting.quiet && reporting.progress == "auto" ? Display::bar
                                                                        : Display::none;
}

// Prints only when the percentage changes.
class ProgressDisplay {
public:
    explicit ProgressDisplay(Display display) : display_(display) {}
    ~ProgressDisplay() {
        if (display_ == Display::bar && percent_ >= 0) {
            std::fprintf(stderr, "\r\033[K");
        }
    }
    ProgressDisplay(const ProgressDisplay&) = delete;
    ProgressDisplay& operator=(const ProgressDisplay&) = delete;

    void show(double fraction) {
        const int percent = static_cast<int>(100.0 * fraction);
        if (percent == percent_) {
            return;
        }
        percent_ = percent;
        if (display_ == Display::json) {
            std::fprintf(stderr, "{\"progress\": %.2f}\n", fraction);
        } else if (display_ == Display::bar) {
            const int full = bar_width * percent / 100;
            std::fprintf(
                stderr, "\r[%s%s] %3d %%", std::string(static_cast<std::size_t>(full), '#').c_str(),
                std::string(static_cast<std::size_t>(bar_width - full), ' ').c_str(), percent);
        }
    }

private:
    Display display_;
    int percent_ = -1;
};

}  // namespace

Moment now() {
    return std::chrono::steady_clock::now();
}

double elapsed_ms(Moment since) {
    return std::chrono::duration<double, std::milli>(now() - since).count();
}

Result<Model> load_model(const std::string& path, const Reporting& reporting) {
    return load_models({path}, reporting);
}

Result<Model> load_models(const std::vector<std::string>& paths, const Reporting& reporting) {
    set_time_limit(reporting.time_limit_s);
    const Moment start = now();
    ProgressDisplay display(chosen_display(reporting));
    Progress* progress_in_use = nullptr;
    Progress progress([&](double fraction) {
        display.show(fraction);
        if (is_interrupted()) {
            progress_in_use->cancel();
        }
    });
    progress_in_use = &progress;
    Result<Scene> scene = load_scenes(paths, {}, progress);
    if (!scene) {
        return scene.error();
    }
    std::string path = paths.front();
    for (std::size_t i = 1; i < paths.size(); ++i) {
        path += " + " + paths[i];
    }
    Model model{path, std::move(scene).value(), 0.0};
    model.load_ms = elapsed_ms(start);
    return model;
}

Status save_model(const Scene& scene, const std::string& path) {
    if (path != "-") {
        return save_scene(scene, path);
    }
    Result<Output> output = Output::create(path);
    if (!output) {
        return output.error();
    }
    const Status written = export_rvm(scene, output.value());
    return written ? output.value().commit() : written;
}

}  // namespace quartic::cli
