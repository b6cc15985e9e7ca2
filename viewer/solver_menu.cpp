// The menu of solvers: one for everything, or each material's own.
#include "solvers/solver_table.h"
#include "viewer/panels.h"

#include <imgui.h>

namespace quartic::viewer {
namespace {

// The number of the solver that was chosen just now.
std::optional<int> choose_solver(int current) {
    std::optional<int> chosen;
    for (const SolverRow& row : solver_table()) {
        const std::string text = spoken(row.name);
        if (ImGui::MenuItem(text.c_str(), nullptr, current == row.id)) {
            chosen = row.id;
        }
        if (ImGui::IsItemHovered()) {
            const std::string more = std::string(row.solves) + "; " + std::string(row.source);
            ImGui::SetTooltip("%s", more.c_str());
        }
    }
    return chosen;
}

std::string material_name(const App& app, std::uint32_t material) {
    const std::string& name = app.model->scene.materials[material].name;
    const std::string number = std::to_string(material + 1);
    // What follows ## tells Dear ImGui two materials of one name apart.
    return (name.empty() ? "material " + number : name) + "##" + number;
}

void show_materials(App& app) {
    for (const std::uint32_t material : app.solved_materials) {
        if (!ImGui::BeginMenu(material_name(app, material).c_str())) {
            continue;
        }
        const int own = app.material_solvers[material];
        if (const auto solver = choose_solver(own == 0 ? solver_default : own)) {
            change_material_solver(app, material, *solver);
        }
        ImGui::EndMenu();
    }
}

}  // namespace

void show_solver_menu(App& app) {
    const bool has_choice = app.model && !app.solved_materials.empty();
    if (ImGui::BeginMenu("Materials", has_choice)) {
        show_materials(app);
        ImGui::EndMenu();
    }
    if (ImGui::MenuItem("As the materials say", nullptr, app.next_solver == 0)) {
        change_solver(app, 0);
    }
    ImGui::Separator();
    if (const auto solver = choose_solver(app.next_solver)) {
        change_solver(app, *solver);
    }
}

void show_second_solver_menu(App& app) {
    if (const auto solver = choose_solver(app.maps.choice.second)) {
        app.maps.choice.second = *solver;
        app.second_picture.discard();
        redraw_map(app);
    }
}

}  // namespace quartic::viewer
