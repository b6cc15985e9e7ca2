// What is selected, in the words of scene/describe.h, and its attributes.
#include "viewer/panels.h"

#include <imgui.h>

namespace quartic::viewer {
namespace {

std::string as_text(const std::vector<Property>& list) {
    std::string text;
    for (const Property& property : list) {
        text += property.label + ": " + property.text + "\n";
    }
    return text;
}

void show_list(const char* name, const std::vector<Property>& list) {
    const ImGuiTableFlags flags =
        ImGuiTableFlags_RowBg | ImGuiTableFlags_Resizable | ImGuiTableFlags_BordersInnerV;
    if (!ImGui::BeginTable(name, 2, flags)) {
        return;
    }
    ImGui::TableSetupColumn("label", ImGuiTableColumnFlags_WidthStretch, 0.38f);
    ImGui::TableSetupColumn("text", ImGuiTableColumnFlags_WidthStretch, 0.62f);
    for (const Property& property : list) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        ImGui::TextDisabled("%s", property.label.c_str());
        ImGui::TableNextColumn();
        ImGui::PushTextWrapPos(0.0f);
        ImGui::TextUnformatted(property.text.c_str());
        ImGui::PopTextWrapPos();
    }
    ImGui::EndTable();
}

}  // namespace

void show_properties(App& app) {
    const Selection& selection = app.selection;
    if (selection.node == no_index && selection.part == no_index) {
        ImGui::PushTextWrapPos(0.0f);
        ImGui::TextDisabled(
            "Nothing is selected. Click a part in the picture or a row of the tree.");
        ImGui::PopTextWrapPos();
        return;
    }
    if (ImGui::Button("Copy")) {
        ImGui::SetClipboardText(
            (as_text(selection.properties) + as_text(selection.attributes)).c_str());
        app.notice = "Copied.";
    }
    ImGui::SameLine();
    if (ImGui::Button(std::string(text_of(Action::fit_selection)).c_str())) {
        perform(app, Action::fit_selection);
    }
    ImGui::BeginChild("lists");
    show_list("properties", selection.properties);
    if (!selection.attributes.empty()) {
        ImGui::Spacing();
        ImGui::TextUnformatted("Attributes");
        ImGui::Separator();
        show_list("attributes", selection.attributes);
    }
    ImGui::EndChild();
}

}  // namespace quartic::viewer
