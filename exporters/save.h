// Saves a scene in any known format: a table of exporters, chosen by the name's extension.
#pragma once

#include "diagnostics/result.h"
#include "files/output.h"
#include "scene/scene.h"

#include <span>
#include <string>
#include <string_view>

namespace quartic {

// One format. Extensions are lower case, without the dot. save() writes; its caller commits.
struct Exporter {
    std::string_view name;
    std::span<const std::string_view> extensions;
    Status (*save)(const Scene& scene, Output& output);
    void (*remark)(const Scene& scene, Findings& findings);  // what is not said exactly; or null
};

std::span<const Exporter> exporter_table();

// The exporter for a path's extension, or null.
const Exporter* find_exporter(std::string_view path);

// What a file of this name does not say exactly of the scene; - is RVM.
Findings export_findings(const Scene& scene, std::string_view path);

// Creates the file whole or not at all.
Status save_scene(const Scene& scene, const std::string& path);

}  // namespace quartic
