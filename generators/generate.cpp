// The table of generators.
#include "generators/generate.h"

#include "generators/kinds.h"

#include <cmath>
#include <string>

namespace quartic {
namespace {

constexpr std::uint64_t count_max = 100'000'000;

constexpr GeneratorRow rows[] = {
    {"plant", "process units with racks, pipelines, vessels, machines and steel", 20'000,
     make_plant},
    {"tori", "a cloud of whole tori", 16'000, make_tori},
    {"elbows", "a cloud of pipe elbows", 16'000, make_elbows},
    {"sheet", "every primitive with every awkward parameter", 0, make_sheet},
    {"surfaces", "a gallery of famous cubic and quartic surfaces", 16, make_surfaces},
    {"run", "a short pipe: tube, elbow, tube, reducer, cap", 0, make_run},
};

bool is_finite(const glm::dvec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

}  // namespace

std::span<const GeneratorRow> generator_table() {
    return rows;
}

Result<Scene> generate(std::string_view kind, const GenerateOptions& options) {
    std::string known;
    for (const GeneratorRow& row : rows) {
        known += (known.empty() ? "" : ", ") + std::string(row.name);
        if (row.name != kind) {
            continue;
        }
        if (options.count > count_max) {
            return Error{ErrorKind::usage, "",
                         "expected a count of at most 100000000, found " +
                             std::to_string(options.count) + "; ask for fewer parts"};
        }
        if (!(options.extent_m >= 0.0) || !std::isfinite(options.extent_m) ||
            !is_finite(options.offset)) {
            return Error{
                ErrorKind::usage, "",
                "expected an extent and an offset that are finite, and no negative extent"};
        }
        GenerateOptions resolved = options;
        resolved.count = options.count == 0 ? row.count_default : options.count;
        Scene scene = row.make(resolved);
        scene.title = row.name;
        for (Node& node : scene.nodes) {
            node.position += options.offset;
        }
        for (Part& part : scene.parts) {
            part.placement.position += options.offset;
        }
        return scene;
    }
    return Error{ErrorKind::usage, "",
                 "expected one of " + known + ", found '" + std::string(kind) +
                     "'; choose one of these kinds"};
}

}  // namespace quartic
