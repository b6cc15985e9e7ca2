// Reads, joins, packs and indexes a model on a thread of its own.
#include "viewer/model.h"

#include "scene/joints.h"
#include "viewer/window.h"

#include <chrono>
#include <exception>
#include <utility>

namespace quartic::viewer {
namespace {

Result<std::unique_ptr<Model>> load_model(const std::string& path, int solver, Progress& progress) {
    const auto start = std::chrono::steady_clock::now();
    Result<Scene> scene = load_scene(path, {}, progress);
    if (!scene) {
        return scene.error();
    }
    auto model = std::make_unique<Model>();
    model->path = path;
    model->scene = std::move(scene).value();
    if (!progress.cancelled()) {
        find_joints(model->scene);
        model->hierarchy = Hierarchy(model->scene);
    }
    if (!progress.cancelled()) {
        model->packed = pack(model->scene, {.solver = solver});
        model->box = model->packed.box;
    }
    const std::chrono::duration<double, std::milli> elapsed =
        std::chrono::steady_clock::now() - start;
    model->load_ms = elapsed.count();
    return model;
}

}  // namespace

Loading::Loading(std::string path, int solver)
    : path_(std::move(path)),
      progress_([this](double fraction) {
          fraction_ = fraction;
          Window::wake();
      }),
      result_(Error{ErrorKind::interrupted, path_, "not finished"}),
      thread_([this, solver] { run(solver); }) {}

Loading::~Loading() {
    progress_.cancel();
    thread_.join();
}

void Loading::run(int solver) {
    try {
        result_ = load_model(path_, solver, progress_);
    } catch (const std::exception& exception) {  // out of memory
        result_ = Error{ErrorKind::io, path_, std::string("opening failed: ") + exception.what()};
    }
    finished_ = true;
    Window::wake();
}

Result<std::unique_ptr<Model>> Loading::take() {
    return std::exchange(result_, Error{ErrorKind::interrupted, path_, "already taken"});
}

std::string file_name(const std::string& path) {
    return path.substr(path.find_last_of('/') + 1);
}

}  // namespace quartic::viewer
