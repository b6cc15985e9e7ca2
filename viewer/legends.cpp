// Over each half of the view: which solver draws it, and what the colours of its map mean.
#include "viewer/panels.h"

#include <imgui.h>

namespace quartic::viewer {
namespace {

constexpr ImGuiWindowFlags legend_flags =
    ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoSavedSettings |
    ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing |
    ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoNav;
constexpr double bar_width = 180.0;
constexpr double bar_height = 10.0;
constexpr int bar_pieces = 60;

ImU32 colour_of(const Rgb& colour) {
    return IM_COL32(colour.red, colour.green, colour.blue, 255);
}

// Room for a rectangle where the next widget would stand; returns its upper left corner.
ImVec2 take_room(double width, double height) {
    const ImVec2 place = ImGui::GetCursorScreenPos();
    ImGui::Dummy(ImVec2(static_cast<float>(width), static_cast<float>(height)));
    return place;
}

void show_bar(const Legend& legend, double scale) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    // The outer ticks' texts stand half beside the bar.
    const auto aside =
        static_cast<double>(ImGui::CalcTextSize(legend.ticks.front().text.c_str()).x) / 2.0;
    const auto width = static_cast<float>(bar_width * scale);
    const auto height = static_cast<float>(bar_height * scale);
    const auto line = static_cast<double>(ImGui::GetTextLineHeight());
    ImVec2 low = take_room(bar_width * scale + 3.0 * aside, bar_height * scale + line);
    low.x += static_cast<float>(aside);
    for (int i = 0; i < bar_pieces; ++i) {
        const float from = width * static_cast<float>(i) / bar_pieces;
        const float to = width * static_cast<float>(i + 1) / bar_pieces;
        list.AddRectFilled(ImVec2(low.x + from, low.y), ImVec2(low.x + to, low.y + height),
                           colour_of(heat_colour((i + 0.5) / bar_pieces)));
    }
    for (const LegendTick& tick : legend.ticks) {
        const float half = ImGui::CalcTextSize(tick.text.c_str()).x / 2.0f;
        list.AddText(ImVec2(low.x + static_cast<float>(tick.place) * width - half, low.y + height),
                     ImGui::GetColorU32(ImGuiCol_Text), tick.text.c_str());
    }
}

void show_legend(const Legend& legend, double scale) {
    ImGui::TextUnformatted(legend.title.c_str());
    if (!legend.ticks.empty()) {
        show_bar(legend, scale);
    }
    for (const LegendLine& line : legend.lines) {
        const auto side = static_cast<double>(ImGui::GetTextLineHeight());
        const ImVec2 low = take_room(side, side);
        const auto inner = static_cast<float>(side);
        ImGui::GetWindowDrawList()->AddRectFilled(low, ImVec2(low.x + inner, low.y + inner),
                                                  colour_of(line.colour));
        ImGui::SameLine();
        ImGui::TextUnformatted(line.text.c_str());
    }
}

// In the upper left corner of a half, which begins at this part of the view's width.
void show_corner(const App& app, double from, int solver, std::size_t map) {
    const double gap = 8.0 * app.scale;
    ImGui::SetNextWindowPos(
        ImVec2(static_cast<float>(app.view.low.x + from * app.view.extent.x + gap),
               static_cast<float>(app.view.low.y + gap)));
    ImGui::SetNextWindowBgAlpha(0.85f);
    const std::string name = "Legend " + std::to_string(map);
    if (ImGui::Begin(name.c_str(), nullptr, legend_flags)) {
        if (app.maps.choice.kind != MapKind::difference) {
            ImGui::TextUnformatted(solver_name(app, solver).c_str());
        }
        if (is_map_shown(app)) {
            show_legend(app.maps.maps[map].legend, app.scale);
        } else if (is_map_awaited(app)) {
            const std::string title(row_of(*app.maps.choice.kind).title);
            ImGui::TextDisabled("%s: being worked out ...", title.c_str());
        }
    }
    ImGui::End();
}

}  // namespace

void show_legends(const App& app) {
    if (!app.model || (!app.maps.choice.kind && !is_split(app))) {
        return;
    }
    show_corner(app, 0.0, app.solver, 0);
    if (is_split(app)) {
        show_corner(app, app.maps.choice.divider, app.maps.choice.second, 1);
    }
}

}  // namespace quartic::viewer
