// The table of exporters.
#include "exporters/save.h"

#include "exporters/pov.h"
#include "exporters/rvm.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

namespace quartic {
namespace {

constexpr std::array<std::string_view, 1> rvm_extensions{"rvm"};

constexpr std::array<std::string_view, 1> pov_extensions{"pov"};

constexpr Exporter exporters[] = {
    {"rvm", rvm_extensions, export_rvm, remark_rvm},
    {"pov", pov_extensions, export_pov, remark_pov},
};

std::string extension_of(std::string_view path) {
    const std::size_t dot = path.rfind('.');
    std::string extension;
    if (dot != std::string_view::npos && path.find('/', dot) == std::string_view::npos) {
        extension = path.substr(dot + 1);
    }
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension;
}

}  // namespace

std::span<const Exporter> exporter_table() {
    return exporters;
}

const Exporter* find_exporter(std::string_view path) {
    const std::string extension = extension_of(path);
    for (const Exporter& exporter : exporters) {
        if (std::ranges::find(exporter.extensions, extension) != exporter.extensions.end()) {
            return &exporter;
        }
    }
    return nullptr;
}

Findings export_findings(const Scene& scene, std::string_view path) {
    Findings findings;
    const Exporter* exporter = path == "-" ? &exporters[0] : find_exporter(path);
    if (exporter != nullptr && exporter->remark != nullptr) {
        exporter->remark(scene, findings);
    }
    return findings;
}

Status save_scene(const Scene& scene, const std::string& path) {
    const Exporter* exporter = find_exporter(path);
    if (exporter == nullptr) {
        std::string known;
        for (const Exporter& row : exporters) {
            for (const std::string_view extension : row.extensions) {
                known += (known.empty() ? "." : ", .") + std::string(extension);
            }
        }
        return Error{
            ErrorKind::usage, path,
            "expected a name that ends in one of " + known + "; choose one of these formats"};
    }
    Result<Output> output = Output::create(path);
    if (!output) {
        return output.error();
    }
    if (Status saved = exporter->save(scene, output.value()); !saved) {
        Error error = saved.error();
        error.where = error.where.empty() ? path : path + ", " + error.where;
        return error;
    }
    return output.value().commit();
}

}  // namespace quartic
