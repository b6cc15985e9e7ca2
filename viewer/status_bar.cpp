// The line at the bottom: what was just done or can be done, and figures of the picture.
#include "viewer/panels.h"

#include <imgui.h>

#include <cstdio>

namespace quartic::viewer {
namespace {

constexpr const char* hint =
    "Left drag: orbit   Middle drag: pan   Wheel: zoom   Click: select   F: fit   F1: all keys";

std::string extent_text(const Box3& box) {
    if (box.empty()) {
        return "nothing shown";
    }
    const glm::dvec3 extent = box.high - box.low;
    char text[128];
    std::snprintf(text, sizeof(text), "%.2f x %.2f x %.2f m", extent.x, extent.y, extent.z);
    return text;
}

std::string counts_text(const App& app) {
    const FrameCounts& counts = app.counts;
    return std::to_string(counts.drawn) + " parts drawn, " +
           std::to_string(counts.culled_by_frustum + counts.culled_by_size) + " culled";
}

std::string time_text(double time_ms) {
    char text[64];
    std::snprintf(text, sizeof(text), "%.1f ms", time_ms);
    return text;
}

void show_figure(const std::string& text) {
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(text.c_str());
}

// The driver's name without what it adds in brackets.
std::string short_name(const std::string& renderer) {
    return renderer.substr(0, renderer.find(" ("));
}

void show_figures(const App& app) {
    const std::string left = !app.notice.empty() ? app.notice
                             : app.model         ? std::string(hint)
                                         : "Ctrl+O or a dropped file opens a model   F1: all keys";
    show_figure(left);
    show_figure(app.cursor_point ? position_text(*app.cursor_point) : std::string());
    show_figure(app.model ? extent_text(app.shown_box) : std::string());
    show_figure(app.model ? counts_text(app) : std::string());
    show_figure(app.model ? time_text(app.picture.draw_ms()) : std::string());
    show_figure(short_name(app.renderer_is.renderer));
}

}  // namespace

void show_status_bar(const App& app) {
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const float height = ImGui::GetFrameHeight();
    ImGui::SetNextWindowPos(ImVec2(0.0f, display.y - height));
    ImGui::SetNextWindowSize(ImVec2(display.x, height));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding,
                        ImVec2(ImGui::GetStyle().FramePadding.x, ImGui::GetStyle().FramePadding.y));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1.0f, 1.0f));
    ImGui::Begin("Status", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus |
                     ImGuiWindowFlags_NoNav);
    if (ImGui::BeginTable("figures", 6,
                          ImGuiTableFlags_SizingFixedFit | ImGuiTableFlags_BordersInnerV)) {
        ImGui::TableSetupColumn("notice", ImGuiTableColumnFlags_WidthStretch);
        show_figures(app);
        ImGui::EndTable();
    }
    ImGui::End();
    ImGui::PopStyleVar(2);
}

}  // namespace quartic::viewer
