// A model from a file, ready to be drawn or counted.
#pragma once

#include "cli/report.h"
#include "scene/scene.h"

#include <chrono>
#include <string>
#include <vector>

namespace quartic::cli {

struct Model {
    std::string path;
    Scene scene;
    double load_ms = 0.0;
};

// Shows progress as the options say. Interrupted if a signal came.
Result<Model> load_model(const std::string& path, const Reporting& reporting);

// As load_model, of several files as one model.
Result<Model> load_models(const std::vector<std::string>& paths, const Reporting& reporting);

// In the format that the path's extension names; - is RVM on standard output.
Status save_model(const Scene& scene, const std::string& path);

// Milliseconds since a moment, by the wall's clock.
using Moment = std::chrono::steady_clock::time_point;
Moment now();
double elapsed_ms(Moment since);

}  // namespace quartic::cli
