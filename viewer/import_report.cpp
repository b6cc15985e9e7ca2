// What became of the file's elements, and what the reader noticed.
#include "viewer/panels.h"

#include <imgui.h>

#include <cstdio>
#include <initializer_list>

namespace quartic::viewer {
namespace {

void show_cells(std::initializer_list<std::string> cells) {
    ImGui::TableNextRow();
    for (const std::string& cell : cells) {
        ImGui::TableNextColumn();
        ImGui::PushTextWrapPos(0.0f);
        ImGui::TextUnformatted(cell.c_str());
        ImGui::PopTextWrapPos();
    }
}

void show_summary(const Model& model) {
    char time[64];
    std::snprintf(time, sizeof(time), "%.2f s", model.load_ms / 1000.0);
    const Scene& scene = model.scene;
    if (ImGui::BeginTable("summary", 2)) {
        show_cells({"File", model.path});
        if (!scene.title.empty()) {
            show_cells({"Title", scene.title});
        }
        show_cells({"Unit, up", scene.unit + ", " + scene.up_axis});
        show_cells({"Nodes", std::to_string(scene.nodes.size())});
        show_cells({"Parts", std::to_string(scene.parts.size())});
        show_cells({"Opened in", time});
        ImGui::EndTable();
    }
}

void show_outcomes(const Scene& scene) {
    if (scene.outcomes.empty() ||
        !ImGui::BeginTable("outcomes", 4, ImGuiTableFlags_RowBg | ImGuiTableFlags_Resizable)) {
        return;
    }
    for (const char* const title : {"Kind", "Became", "Count", "Why"}) {
        ImGui::TableSetupColumn(title);
    }
    ImGui::TableHeadersRow();
    for (const Outcome& outcome : scene.outcomes) {
        show_cells(
            {spoken(outcome.kind), outcome.became, std::to_string(outcome.count), outcome.reason});
    }
    ImGui::EndTable();
}

void show_findings(const Scene& scene) {
    for (const Finding& finding : scene.findings.list()) {
        std::string text(name(finding.severity));
        text += ": " + finding.text;
        if (finding.count > 1) {
            text += " (" + std::to_string(finding.count) + " times)";
        }
        if (!finding.where.empty()) {
            text += "\n    first at " + finding.where;
        }
        ImGui::PushTextWrapPos(0.0f);
        ImGui::TextUnformatted(text.c_str());
        ImGui::PopTextWrapPos();
    }
}

}  // namespace

void show_import_report(const Model& model) {
    ImGui::BeginChild("report");
    show_summary(model);
    ImGui::Spacing();
    show_outcomes(model.scene);
    ImGui::Spacing();
    ImGui::TextUnformatted("Findings");
    ImGui::Separator();
    if (model.scene.findings.list().empty()) {
        ImGui::TextDisabled("none");
    }
    show_findings(model.scene);
    ImGui::EndChild();
}

}  // namespace quartic::viewer
