// A model as the window holds it, and the thread that opens it.
#pragma once

#include "importers/load.h"
#include "scene/pack.h"
#include "viewer/hierarchy.h"

#include <atomic>
#include <memory>
#include <string>
#include <thread>

namespace quartic::viewer {

struct Model {
    std::string path;
    Scene scene;
    Packed packed;  // emptied once it is on the GPU
    Hierarchy hierarchy;
    Box3 box;  // of all parts
    double load_ms = 0.0;
};

// Opens a file beside the window. The destructor cancels and waits.
class Loading {
public:
    Loading(std::string path, int solver);
    Loading(const Loading&) = delete;
    Loading& operator=(const Loading&) = delete;
    ~Loading();

    const std::string& path() const { return path_; }
    double fraction() const { return fraction_; }
    void cancel() { progress_.cancel(); }
    bool is_cancelled() const { return progress_.cancelled(); }
    bool is_finished() const { return finished_; }
    // Once, when finished.
    Result<std::unique_ptr<Model>> take();

private:
    void run(int solver);

    std::string path_;
    std::atomic<double> fraction_{0.0};
    std::atomic<bool> finished_{false};
    Progress progress_;
    Result<std::unique_ptr<Model>> result_;
    std::thread thread_;
};

// "/data/pump.rvm": "pump.rvm"
std::string file_name(const std::string& path);

}  // namespace quartic::viewer
