// Reads, joins, packs and indexes a model on a thread of its own.
#include "viewer/model.h"

#include "scene/joints.h"
#include "viewer/window.h"

#include <atomic>
#include <chrono>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>

namespace quartic::viewer {

struct Loading::Shared {
    explicit Shared(std::vector<std::string> opened)
        : paths(std::move(opened)), progress([this](double read) {
              fraction = read;
              wake();
          }) {}

    const std::vector<std::string> paths;  // at least one
    std::atomic<double> fraction{0.0};
    std::atomic<const char*> step{"reading"};
    std::atomic<bool> finished{false};
    Progress progress;
    Result<std::unique_ptr<Model>> result = Error{ErrorKind::interrupted, "", "not finished"};

    std::mutex mutex;        // of what follows
    bool is_awaited = true;  // else there may be no window any more

    void wake() {
        const std::scoped_lock lock(mutex);
        if (is_awaited) {
            Window::wake();
        }
    }
    void begin(const char* next) {
        step = next;
        wake();
    }
    Result<std::unique_ptr<Model>> load();
    void run();
};

Result<std::unique_ptr<Model>> Loading::Shared::load() {
    const auto start = std::chrono::steady_clock::now();
    Result<Scene> scene = load_scenes(paths, {}, progress);
    if (!scene) {
        return scene.error();
    }
    auto model = std::make_unique<Model>();
    model->path = paths.front();
    model->scene = std::move(scene).value();
    if (!progress.cancelled()) {
        begin("finding joints");
        find_joints(model->scene);
    }
    if (!progress.cancelled()) {
        begin("packing");
        model->hierarchy = Hierarchy(model->scene);
        model->packed = pack(model->scene);
    }
    const std::chrono::duration<double, std::milli> elapsed =
        std::chrono::steady_clock::now() - start;
    model->load_ms = elapsed.count();
    return model;
}

void Loading::Shared::run() {
    try {
        result = load();
    } catch (const std::exception& exception) {  // out of memory
        result =
            Error{ErrorKind::io, paths.front(), std::string("opening failed: ") + exception.what()};
    }
    finished = true;
    wake();
}

Loading::Loading(std::vector<std::string> paths)
    : shared_(std::make_shared<Shared>(std::move(paths))) {
    std::thread([shared = shared_] { shared->run(); }).detach();
}

Loading::~Loading() {
    shared_->progress.cancel();
    const std::scoped_lock lock(shared_->mutex);
    shared_->is_awaited = false;
}

const std::string& Loading::path() const {
    return shared_->paths.front();
}

double Loading::fraction() const {
    return shared_->fraction;
}

const char* Loading::step() const {
    return shared_->step;
}

bool Loading::is_finished() const {
    return shared_->finished;
}

Result<std::unique_ptr<Model>> Loading::take() {
    return std::exchange(shared_->result, Error{ErrorKind::interrupted, path(), "already taken"});
}

std::string file_name(const std::string& path) {
    return path.substr(path.find_last_of('/') + 1);
}

}  // namespace quartic::viewer
