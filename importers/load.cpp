// Chooses the importer of a file, and turns foreign exceptions into errors.
#include "importers/load.h"

#include "importers/content_name.h"
#include "importers/formats.h"
#include "scene/append.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <exception>
#include <new>

namespace quartic {
namespace {

constexpr std::size_t head_bytes = 4096;  // enough for every recognises()

std::string lower_extension(std::string_view path) {
    const std::size_t slash = path.find_last_of("/\\");
    const std::string_view name = slash == std::string_view::npos ? path : path.substr(slash + 1);
    const std::size_t dot = name.find_last_of('.');
    std::string extension(dot == std::string_view::npos ? std::string_view()
                                                        : name.substr(dot + 1));
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension;
}

bool claims(const Importer& importer, std::string_view extension) {
    return std::find(importer.extensions.begin(), importer.extensions.end(), extension) !=
           importer.extensions.end();
}

// Where the name promises a format, the message says that one; else it lists all.
std::string expected_formats(std::string_view extension) {
    std::string all;
    for (const Importer& importer : importer_table()) {
        if (claims(importer, extension)) {
            return "expected " + std::string(importer.name);
        }
        all += (all.empty() ? "" : ", ") + std::string(importer.name);
    }
    return "expected one of: " + all;
}

Result<Scene> load_recognised(const Source& source, const ImportOptions& options,
                              Progress& progress) {
    const std::string extension = lower_extension(source.path());
    const auto head = source.bytes().first(std::min(source.bytes().size(), head_bytes));
    for (const Importer& importer : importer_table()) {
        if (importer.recognises(head, extension)) {
            return importer.load(source, options, progress);
        }
    }
    return Error{ErrorKind::bad_data, source.path(),
                 expected_formats(extension) + "; found " + content_name(head)};
}

}  // namespace

void Progress::report(double fraction) {
    if (!callback_) {
        return;
    }
    const std::scoped_lock lock(mutex_);
    if (fraction > reported_) {
        reported_ = fraction;
        callback_(fraction);
    }
}

std::span<const Importer> importer_table() {
    static const std::array table{rvm_importer(), rev_importer(), pov_importer()};
    return table;
}

Result<Scene> load_scene(const Source& source, const ImportOptions& options, Progress& progress) {
    try {
        return load_recognised(source, options, progress);
    } catch (const std::bad_alloc&) {
        return Error{ErrorKind::io, source.path(),
                     "expected enough memory for the model, found too little; "
                     "close other programs or load a part of the model"};
    } catch (const std::exception& exception) {
        return Error{ErrorKind::io, source.path(),
                     std::string("reading failed: ") + exception.what()};
    }
}

Result<Scene> load_scene(const std::string& path, const ImportOptions& options,
                         Progress& progress) {
    const Result<Source> source = Source::open(path);
    if (!source) {
        return source.error();
    }
    return load_scene(source.value(), options, progress);
}

Result<Scene> load_scenes(std::span<const std::string> paths, const ImportOptions& options,
                          Progress& progress) {
    Scene all;
    for (std::size_t i = 0; i < paths.size(); ++i) {
        Progress* of_file = nullptr;
        Progress one([&](double fraction) {
            progress.report((static_cast<double>(i) + fraction) /
                            static_cast<double>(paths.size()));
            if (progress.cancelled()) {
                of_file->cancel();
            }
        });
        of_file = &one;
        Result<Scene> scene = load_scene(paths[i], options, one);
        if (!scene) {
            return scene;
        }
        if (i == 0) {
            all = std::move(scene).value();
        } else {
            append_scene(all, std::move(scene).value());
        }
    }
    return all;
}

}  // namespace quartic
