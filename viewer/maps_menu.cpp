// The menu of maps: what is shown instead of the picture, and whether two solvers share the view.
#include "viewer/panels.h"

#include <imgui.h>

#include <cctype>

namespace quartic::viewer {
namespace {

void show_kind(App& app, const char* text, std::optional<MapKind> kind) {
    if (ImGui::MenuItem(text, nullptr, app.maps.choice.kind == kind)) {
        app.maps.choice.kind = kind;
        redraw_map(app);
    }
}

}  // namespace

void show_maps_menu(App& app) {
    show_kind(app, "Picture", std::nullopt);
    for (const MapRow& row : map_table()) {
        std::string text = spoken(row.name);
        text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
        show_kind(app, text.c_str(), row.kind);
        if (ImGui::IsItemHovered()) {
            const std::string more(row.title);
            ImGui::SetTooltip("%s", more.c_str());
        }
    }
    ImGui::Separator();
    const bool can_split = app.maps.choice.kind != MapKind::difference;
    if (ImGui::MenuItem("A/B split", nullptr, is_split(app), can_split)) {
        app.maps.choice.is_split = !app.maps.choice.is_split;
        app.second_picture.discard();
        redraw_map(app);
    }
    if (ImGui::BeginMenu("Second solver")) {
        show_second_solver_menu(app);
        ImGui::EndMenu();
    }
}

}  // namespace quartic::viewer
