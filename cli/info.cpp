// The verb info: what is in a model.
#include "cli/arguments.h"
#include "cli/model.h"
#include "cli/verbs.h"
#include "scene/gpu_layout.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <utility>

namespace quartic::cli {
namespace {

using nlohmann::ordered_json;

struct InfoArguments {
    std::vector<std::string> files;
    Reporting reporting;
};

// Kinds of plant models that are always listed, also where a model has none.
constexpr std::array<std::string_view, 9> usual_kinds{
    "cylinder", "snout", "torus", "dish", "sphere", "rectangular_torus", "box", "pyramid", "line"};

// Kinds that hold triangles or nothing that is known.
bool is_no_primitive(std::string_view kind) {
    return kind == "facet_group" || kind == "mesh" || kind == "unknown";
}

std::uint64_t count_of(const Scene& scene, std::size_t kind) {
    return kind < scene.kind_counts.size() ? scene.kind_counts[kind] : 0;
}

ordered_json primitives_as_json(const Scene& scene) {
    ordered_json counts = ordered_json::object();
    for (const std::string_view kind : usual_kinds) {
        counts[std::string(kind)] = 0;
    }
    for (std::size_t i = 0; i < scene.kinds.size(); ++i) {
        if (!is_no_primitive(scene.kinds[i])) {
            counts[scene.kinds[i]] = count_of(scene, i);
        }
    }
    return counts;
}

ordered_json source_as_json(const Scene& scene) {
    ordered_json counts = ordered_json::object();
    for (std::size_t i = 0; i < scene.kinds.size(); ++i) {
        counts[scene.kinds[i]] = count_of(scene, i);
    }
    return counts;
}

ordered_json outcomes_as_json(const Scene& scene) {
    ordered_json list = ordered_json::array();
    for (const Outcome& outcome : scene.outcomes) {
        list.push_back({{"kind", outcome.kind},
                        {"became", outcome.became},
                        {"reason", outcome.reason},
                        {"count", outcome.count}});
    }
    return list;
}

// Parts as they are drawn: an upright snout is drawn as a cone, for example.
ordered_json shapes_as_json(const Scene& scene) {
    std::array<std::uint64_t, 256> counts{};
    for (const Part& part : scene.parts) {
        ++counts[static_cast<std::size_t>(part.type)];
    }
    ordered_json shapes = ordered_json::object();
    for (const ShapeRow& row : shape_table()) {
        shapes[std::string(row.name)] = counts[static_cast<std::size_t>(row.type)];
    }
    shapes["mesh"] = counts[static_cast<std::size_t>(ShapeType::mesh)];
    return shapes;
}

// Parts that are another placing of a shape or mesh that an earlier part has.
std::uint64_t count_instances(const Scene& scene) {
    std::array<std::vector<bool>, shape_type_count> seen;  // by type: which of its array
    std::uint64_t instances = 0;
    for (const Part& part : scene.parts) {
        std::vector<bool>& of_type = seen[static_cast<std::size_t>(part.type)];
        of_type.resize(std::max<std::size_t>(of_type.size(), part.shape + 1u));
        instances += of_type[part.shape] ? 1u : 0u;
        of_type[part.shape] = true;
    }
    return instances;
}

std::uint64_t count_triangles(const Scene& scene) {
    std::uint64_t triangles = 0;
    for (const Mesh& mesh : scene.meshes) {
        triangles += mesh.indices.size() / 3;
    }
    return triangles;
}

// Of the biggest record that the model needs: a placement and the shape's parameters.
std::size_t bytes_per_instance(const Scene& scene) {
    std::set<ShapeType> types;
    for (const Part& part : scene.parts) {
        types.insert(part.type);
    }
    std::size_t most = 0;
    for (const ShapeRow& row : shape_table()) {
        most = types.contains(row.type) ? std::max(most, row.record_bytes) : most;
    }
    return sizeof(gpu::Placement) + most;
}

ordered_json corner(const Box3& box, const glm::dvec3& point) {
    return box.empty() ? ordered_json(nullptr) : ordered_json{point.x, point.y, point.z};
}

ordered_json as_json(const Model& model) {
    const Scene& scene = model.scene;
    const Box3 box = world_bounds(scene, {true, true, true, true});
    return {{"schema", json_schema},
            {"file", model.path},
            {"title", scene.title},
            {"primitives", primitives_as_json(scene)},
            {"shapes", shapes_as_json(scene)},
            {"meshes", scene.meshes.size()},
            {"triangles", count_triangles(scene)},
            {"nodes", scene.nodes.size()},
            {"attributes", scene.attributes.size()},
            {"parts", scene.parts.size()},
            {"instances", count_instances(scene)},
            {"materials", scene.materials.size()},
            {"source", source_as_json(scene)},
            {"outcome", outcomes_as_json(scene)},
            {"bounds", {{"low", corner(box, box.low)}, {"high", corner(box, box.high)}}},
            {"unit", scene.unit},
            {"up_axis", scene.up_axis},
            {"bytes_per_instance_gpu", bytes_per_instance(scene)},
            {"max_deviation_m", scene.max_deviation_m},
            {"load_ms", model.load_ms},
            {"peak_memory_bytes", peak_memory_bytes()},
            {"findings", findings_as_json(scene.findings)}};
}

std::string line(const std::string& label, const std::string& text) {
    std::string padded = label;
    padded.resize(std::max(label.size() + 1, std::size_t{20}), ' ');
    return padded + text + "\n";
}

std::string corner_text(const glm::dvec3& corner) {
    std::array<char, 96> text{};
    std::snprintf(text.data(), text.size(), "%.3f, %.3f, %.3f m", corner.x, corner.y, corner.z);
    return text.data();
}

std::string as_text(const Model& model) {
    const Scene& scene = model.scene;
    std::string text = model.path + "\n";
    text += scene.title.empty() ? "" : line("title", scene.title);
    for (std::size_t i = 0; i < scene.kinds.size(); ++i) {
        const std::uint64_t count = count_of(scene, i);
        text += count == 0 ? "" : line(scene.kinds[i], std::to_string(count));
    }
    text += line("meshes", std::to_string(scene.meshes.size()));
    text += line("triangles", std::to_string(count_triangles(scene)));
    text += line("nodes", std::to_string(scene.nodes.size()));
    text += line("instances", std::to_string(count_instances(scene)));
    const Box3 box = world_bounds(scene, {true, true, true, true});
    if (!box.empty()) {
        text += line("low", corner_text(box.low)) + line("high", corner_text(box.high));
    }
    text += line("unit", scene.unit) + line("up axis", scene.up_axis);
    text += line("bytes per instance", std::to_string(bytes_per_instance(scene)) + " on the GPU");
    for (const Outcome& outcome : scene.outcomes) {
        if (!outcome.reason.empty()) {
            text += line(outcome.became, std::to_string(outcome.count) + " x " + outcome.kind +
                                             ": " + outcome.reason);
        }
    }
    for (const Finding& finding : scene.findings.list()) {
        text +=
            line(std::string(name(finding.severity)),
                 std::to_string(finding.count) + " x " + finding.text + " (" + finding.where + ")");
    }
    return text;
}

// One model: its document. Several: a list of them.
ExitCode info(const InfoArguments& arguments) {
    ordered_json documents = ordered_json::array();
    std::string text;
    ExitCode code = exit_ok;
    for (const std::string& path : arguments.files) {
        const Result<Model> model = load_model(path, arguments.reporting);
        if (!model) {
            code = worse_of(code, report_error(model.error()));
            continue;
        }
        if (arguments.reporting.json) {
            documents.push_back(as_json(model.value()));
        } else {
            text += (text.empty() ? "" : "\n") + as_text(model.value());
        }
        code = worse_of(code,
                        report_findings(path, model.value().scene.findings, arguments.reporting));
    }
    if (!arguments.reporting.json) {
        return worse_of(code, print_text(text));
    }
    if (arguments.files.size() > 1) {
        return worse_of(code, print_json({{"schema", json_schema}, {"files", documents}}));
    }
    return documents.empty() ? code : worse_of(code, print_json(documents[0]));
}

}  // namespace

void add_info(CLI::App& program, Run& run) {
    const auto arguments = std::make_shared<InfoArguments>();
    CLI::App& verb = *program.add_subcommand("info", "say what is in a model");
    verb.footer("Example: quartic info plant.rvm --json");
    verb.add_option("FILE", arguments->files, "models; - is standard input")
        ->required()
        ->default_str("");
    add_reporting(verb, arguments->reporting);
    verb.callback([&run, arguments] { run = [arguments] { return info(*arguments); }; });
}

}  // namespace quartic::cli
