// A model as the window holds it, and the thread that opens it.
#pragma once

#include "importers/load.h"
#include "scene/pack.h"
#include "viewer/hierarchy.h"

#include <memory>
#include <string>
#include <vector>

namespace quartic::viewer {

struct Model {
    std::string path;
    Scene scene;
    Packed packed;  // emptied once it is on the GPU
    Hierarchy hierarchy;
    double load_ms = 0.0;
};

// Opens files, as one model, beside the window. Whoever lets go of it cancels it and does not wait:
// a step that cannot be cancelled ends by itself, on its thread.
class Loading {
public:
    explicit Loading(std::vector<std::string> paths);
    Loading(const Loading&) = delete;
    Loading& operator=(const Loading&) = delete;
    ~Loading();

    const std::string& path() const;  // of the first file
    double fraction() const;          // of the reading
    const char* step() const;         // "reading", ...
    bool is_finished() const;
    // Once, when finished.
    Result<std::unique_ptr<Model>> take();

private:
    struct Shared;
    std::shared_ptr<Shared> shared_;  // with the thread
};

// "/data/pump.rvm": "pump.rvm"
std::string file_name(const std::string& path);

}  // namespace quartic::viewer
