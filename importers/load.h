// Opens a model of any known format: a table of importers, chosen by the bytes first and the name
// second.
#pragma once

#include "diagnostics/result.h"
#include "files/source.h"
#include "scene/scene.h"

#include <atomic>
#include <cstddef>
#include <functional>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace quartic {

struct ImportOptions {
    int thread_count = 0;                        // 0: as many as the machine has
    std::optional<std::string> attributes_path;  // none: the file of the same name beside the model
    bool find_attributes = true;                 // false: only attributes_path counts
};

// How far an import has come, and the way to stop it. Any thread may call any function.
class Progress {
public:
    using Callback = std::function<void(double fraction)>;

    Progress() = default;
    explicit Progress(Callback callback) : callback_(std::move(callback)) {}

    // The callback runs on the thread that reports, never on two at once, and never backwards.
    void report(double fraction);

    void cancel() { cancelled_.store(true, std::memory_order_relaxed); }
    bool cancelled() const { return cancelled_.load(std::memory_order_relaxed); }

private:
    Callback callback_;
    std::mutex mutex_;
    double reported_ = 0.0;
    std::atomic<bool> cancelled_{false};
};

// One format. Extensions are lower case, without the dot.
struct Importer {
    std::string_view name;
    std::span<const std::string_view> extensions;
    bool (*recognises)(std::span<const std::byte> head, std::string_view extension);
    Result<Scene> (*load)(const Source& source, const ImportOptions& options, Progress& progress);
};

std::span<const Importer> importer_table();

// Exceptions of the standard library (out of memory, no thread) end here, as an Error.
Result<Scene> load_scene(const std::string& path, const ImportOptions& options, Progress& progress);
Result<Scene> load_scene(const Source& source, const ImportOptions& options, Progress& progress);

// Several files as one model, in their order. The first that cannot be loaded ends it.
Result<Scene> load_scenes(std::span<const std::string> paths, const ImportOptions& options,
                          Progress& progress);

}  // namespace quartic
