// The line at the bottom: what was just done or can be done, and figures of the picture.
#include "viewer/panels.h"

#include <imgui.h>

#include <algorithm>
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

// The driver's name without what it adds in brackets.
std::string short_name(const std::string& renderer) {
    return renderer.substr(0, renderer.find(" ("));
}

std::string notice_text(const App& app) {
    if (!app.notice.empty()) {
        return app.notice;
    }
    return app.model ? hint : "Ctrl+O or a dropped file opens a model   F1: all keys";
}

// From the cursor's place to the driver's name, with lines between them.
std::string figures_text(const App& app) {
    std::string text = app.cursor_point ? position_text(*app.cursor_point) + "  |  " : "";
    if (app.model) {
        text += extent_text(app.shown_box) + "  |  " + counts_text(app) + "  |  " +
                time_text(app.picture.draw_ms()) + "  |  ";
    }
    return text + short_name(app.renderer_is.renderer);
}

// Figures at the right, and as much of the notice as they leave room for.
void show_line(const App& app) {
    const std::string figures = figures_text(app);
    const std::string notice = notice_text(app);
    const float gap = ImGui::GetStyle().WindowPadding.x;
    const float split =
        std::max(gap, ImGui::GetWindowWidth() - gap - ImGui::CalcTextSize(figures.c_str()).x);
    const ImVec2 low = ImGui::GetWindowPos();
    ImGui::PushClipRect(low, ImVec2(low.x + split - gap, low.y + ImGui::GetWindowHeight()), true);
    ImGui::TextUnformatted(notice.c_str());
    ImGui::PopClipRect();
    ImGui::SameLine(split);
    ImGui::TextUnformatted(figures.c_str());
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
    show_line(app);
    ImGui::End();
    ImGui::PopStyleVar(2);
}

}  // namespace quartic::viewer
