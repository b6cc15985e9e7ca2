// What the program knows of itself: its version, solvers, formats, and the machine it runs on.
#include "cli/verbs.h"
#include "exporters/save.h"
#include "importers/load.h"
#include "render/context.h"
#include "solvers/solver_table.h"

#include <nlohmann/json.hpp>

#include <memory>
#include <span>
#include <string>
#include <thread>

namespace quartic::cli {
namespace {

using nlohmann::ordered_json;

struct Lists {
    bool version = false;
    bool solvers = false;
    bool formats = false;
    bool system = false;
    bool json = false;
};

ExitCode list_version(bool json) {
    if (!json) {
        return print_text("quartic " QUARTIC_VERSION "\n");
    }
    return print_json({{"schema", json_schema}, {"version", QUARTIC_VERSION}});
}

ExitCode list_solvers(bool json) {
    ordered_json rows = ordered_json::array();
    std::string text;
    for (const SolverRow& row : solver_table()) {
        rows.push_back({{"id", row.id},
                        {"name", row.name},
                        {"solves", row.solves},
                        {"source", row.source},
                        {"default", row.id == solver_default}});
        text += std::string(row.name) + (row.id == solver_default ? " (default)" : "") + ": " +
                std::string(row.solves) + "; " + std::string(row.source) + "\n";
    }
    return json ? print_json({{"schema", json_schema}, {"solvers", rows}}) : print_text(text);
}

// Importers and exporters have rows of one form.
template <class Row>
void add_formats(std::span<const Row> table, const std::string& direction, ordered_json& rows,
                 std::string& text) {
    for (const Row& row : table) {
        ordered_json extensions = ordered_json::array();
        std::string names;
        for (const std::string_view extension : row.extensions) {
            extensions.push_back(extension);
            names += (names.empty() ? "." : ", .") + std::string(extension);
        }
        rows.push_back({{"name", row.name}, {"direction", direction}, {"extensions", extensions}});
        text += direction + " " + names + ": " + std::string(row.name) + "\n";
    }
}

ExitCode list_formats(bool json) {
    ordered_json rows = ordered_json::array();
    std::string text;
    add_formats(importer_table(), "read", rows, text);
    add_formats(exporter_table(), "write", rows, text);
    return json ? print_json({{"schema", json_schema}, {"formats", rows}}) : print_text(text);
}

// No OpenGL is something to say here, not a failure.
ExitCode list_system(bool json) {
    ordered_json document{{"schema", json_schema},
                          {"version", QUARTIC_VERSION},
                          {"build", QUARTIC_BUILD_TYPE},
                          {"compiler", __VERSION__},
                          {"threads", std::thread::hardware_concurrency()}};
    const Result<HeadlessContext> context = HeadlessContext::create();
    if (context) {
        const RendererName name = renderer_name();
        document["renderer"] = name.renderer;
        document["opengl"] = name.version;
        document["software"] = name.software;
    } else {
        document["renderer"] = nullptr;
        document["opengl_error"] = context.error().message;
    }
    if (json) {
        return print_json(document);
    }
    std::string text;
    for (const auto& [key, value] : document.items()) {
        text += key + ": " + (value.is_string() ? value.get<std::string>() : value.dump()) + "\n";
    }
    return print_text(text);
}

ExitCode print_lists(const Lists& lists) {
    if (lists.version) {
        return list_version(lists.json);
    }
    if (lists.solvers) {
        return list_solvers(lists.json);
    }
    return lists.formats ? list_formats(lists.json) : list_system(lists.json);
}

}  // namespace

void add_lists(CLI::App& program, Run& run) {
    const auto lists = std::make_shared<Lists>();
    program.add_flag("--version", lists->version, "print the version");
    program.add_flag("--list-solvers", lists->solvers, "print the solvers");
    program.add_flag("--list-formats", lists->formats,
                     "print the formats that can be read and written");
    program.add_flag("--system", lists->system, "print what this machine offers");
    program.add_flag("--json", lists->json, "as JSON");
    program.callback([&run, lists] {
        if (lists->version || lists->solvers || lists->formats || lists->system) {
            run = [lists] { return print_lists(*lists); };
        }
    });
}

}  // namespace quartic::cli
