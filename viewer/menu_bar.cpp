// The menu bar: every action with its key, layers, solvers, maps.
#include "viewer/panels.h"

#include <imgui.h>

namespace quartic::viewer {
namespace {

void show_item(App& app, Action action, bool checked = false, bool enabled = true) {
    const std::string text(text_of(action));
    if (ImGui::MenuItem(text.c_str(), first_key_of(action).c_str(), checked, enabled)) {
        perform(app, action);
    }
}

void show_file_menu(App& app) {
    show_item(app, Action::open_file);
    show_item(app, Action::take_screenshot, false, app.model != nullptr);
    ImGui::Separator();
    show_item(app, Action::quit);
}

void show_view_menu(App& app) {
    for (const Action action : {Action::fit_all, Action::fit_selection, Action::view_front,
                                Action::view_back, Action::view_right, Action::view_left,
                                Action::view_top, Action::view_bottom, Action::view_iso}) {
        show_item(app, action);
        if (action == Action::fit_selection) {
            ImGui::Separator();
        }
    }
    ImGui::Separator();
    show_item(app, Action::toggle_projection, app.camera.projection == Projection::orthographic);
    show_item(app, Action::toggle_edges, app.options.edges);
    show_item(app, Action::toggle_occlusion, app.options.occlusion);
    ImGui::Separator();
    ImGui::MenuItem("Tree", nullptr, &app.panels.tree);
    ImGui::MenuItem("Properties", nullptr, &app.panels.properties);
}

void show_layers_menu(App& app) {
    constexpr std::array names{"Normal", "Obstruction", "Insulation", "Lines"};
    static_assert(names.size() == layer_count);
    for (std::size_t i = 0; i < layer_count; ++i) {
        if (ImGui::MenuItem(names[i], nullptr, &app.options.layers[i])) {
            change_layers(app);
        }
    }
}

}  // namespace

void show_menu_bar(App& app) {
    if (!ImGui::BeginMainMenuBar()) {
        return;
    }
    struct Menu {
        const char* title;
        void (*show)(App&);
    };
    constexpr Menu menus[] = {
        {"File", show_file_menu},
        {"View", show_view_menu},
        {"Layers", show_layers_menu},
        {"Solver", show_solver_menu},
        {"Maps", show_maps_menu},
        {"Help", [](App& of) { show_item(of, Action::toggle_help, of.panels.help); }}};
    for (const Menu& menu : menus) {
        if (ImGui::BeginMenu(menu.title)) {
            menu.show(app);
            ImGui::EndMenu();
        }
    }
    ImGui::EndMainMenuBar();
}

}  // namespace quartic::viewer
