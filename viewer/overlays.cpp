// Windows over the picture: help, progress, failures.
#include "viewer/panels.h"

#include <imgui.h>

#include <cstdio>

namespace quartic::viewer {
namespace {

constexpr ImGuiWindowFlags overlay_flags = ImGuiWindowFlags_NoCollapse |
                                           ImGuiWindowFlags_AlwaysAutoResize |
                                           ImGuiWindowFlags_NoSavedSettings;

// In the middle of the model's picture; the user may move it, if it does not stay only for a while.
void place_overlay(const App& app, ImGuiCond when) {
    const bool has_view = app.view.size_px.width > 0;  // not yet in the first frame
    const glm::dvec2 middle = app.view.low + 0.5 * app.view.extent;
    ImGui::SetNextWindowPos(has_view
                                ? ImVec2(static_cast<float>(middle.x), static_cast<float>(middle.y))
                                : ImGui::GetMainViewport()->GetCenter(),
                            when, ImVec2(0.5f, 0.5f));
}

void show_line(std::string_view keys, std::string_view text) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(keys.data(), keys.data() + keys.size());
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(text.data(), text.data() + text.size());
}

}  // namespace

void show_help(App& app) {
    if (!app.panels.help) {
        return;
    }
    place_overlay(app, ImGuiCond_Appearing);
    if (ImGui::Begin("Keys and mouse", &app.panels.help, overlay_flags) &&
        ImGui::BeginTable("bindings", 2, ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingFixedFit)) {
        for (const GestureRow& row : gesture_table()) {
            show_line(row.keys, row.text);
        }
        for (const GestureRow& row : fixed_gestures()) {
            show_line(row.keys, row.text);
        }
        for (const ActionRow& row : action_table()) {
            show_line(keys_of(row.action), row.text);
        }
        ImGui::EndTable();
    }
    ImGui::End();
}

void show_loading(App& app) {
    if (!app.loading) {
        return;
    }
    place_overlay(app, ImGuiCond_Always);
    bool is_cancelled = false;
    const auto width = static_cast<float>(320.0 * app.scale);
    const std::string name = file_name(app.loading->path());
    if (ImGui::Begin("Opening", nullptr, overlay_flags)) {
        ImGui::TextUnformatted(name.c_str());
        ImGui::ProgressBar(static_cast<float>(app.loading->fraction()), ImVec2(width, 0.0f));
        ImGui::TextDisabled("%s", app.loading->step());
        is_cancelled = ImGui::Button("Cancel");
    }
    ImGui::End();
    if (is_cancelled) {
        cancel_loading(app);
    }
}

void show_failure(App& app) {
    if (app.failure.empty()) {
        return;
    }
    place_overlay(app, ImGuiCond_Appearing);
    bool is_open = true;
    if (ImGui::Begin("This did not work", &is_open, overlay_flags)) {
        ImGui::PushTextWrapPos(static_cast<float>(520.0 * app.scale));
        ImGui::TextUnformatted(app.failure.c_str());
        ImGui::PopTextWrapPos();
        is_open = !ImGui::Button("Close") && is_open;
    }
    ImGui::End();
    if (!is_open) {
        app.failure.clear();
    }
}

}  // namespace quartic::viewer
