// The model's tree: only the rows in sight cost anything.
#include "viewer/panels.h"

#include <imgui.h>
#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include <algorithm>

namespace quartic::viewer {
namespace {

// What the user did to a row.
struct Touched {
    std::uint32_t toggled = no_index;
    std::uint32_t node = no_index;
    std::uint32_t part = no_index;
    bool is_double = false;
};

std::string label_of_node(const Scene& scene, std::uint32_t node) {
    const std::string_view name = scene.strings[scene.nodes[node].name];
    return name.empty() ? "(unnamed)" : std::string(name);
}

// The kind and what tells it from its neighbours first: "cylinder 168.3 mm".
std::string label_of_part(const Scene& scene, std::uint32_t part) {
    const Part& owner = scene.parts[part];
    const bool has_kind = owner.kind < scene.kinds.size();
    std::string label =
        spoken(has_kind ? std::string_view(scene.kinds[owner.kind]) : name(owner.type));
    const std::vector<Property> parameters = describe_shape(scene, owner);
    return parameters.empty() ? label : label + "  " + parameters.front().text;
}

bool show_label(const std::string& label, bool selected, bool dimmed) {
    if (dimmed) {
        ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
    }
    const bool pressed = ImGui::Selectable(
        label.c_str(), selected,
        ImGuiSelectableFlags_AllowDoubleClick | ImGuiSelectableFlags_AllowItemOverlap);
    if (dimmed) {
        ImGui::PopStyleColor();
    }
    return pressed;
}

void show_row(const App& app, const TreeRow& row, Touched& touched) {
    const Scene& scene = app.model->scene;
    const float step = ImGui::GetFontSize();
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() +
                         step * static_cast<float>(std::min(row.depth, 40u)));
    if (row.is_part) {
        ImGui::Dummy(ImVec2(step, step));
        ImGui::SameLine();
        if (show_label(label_of_part(scene, row.id), app.selection.part == row.id,
                       app.selection.part != row.id)) {
            touched.part = row.id;
        }
        return;
    }
    const bool has_more = !app.model->hierarchy.children(row.id).empty() ||
                          !app.model->hierarchy.parts(row.id).empty();
    if (!has_more) {
        ImGui::Dummy(ImVec2(step, step));
    } else {
        ImGui::PushStyleColor(ImGuiCol_Button, ImVec4(0.0f, 0.0f, 0.0f, 0.0f));
        ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(0.0f, 0.0f));
        if (ImGui::ArrowButtonEx("fold",
                                 app.tree.is_unfolded(row.id) ? ImGuiDir_Down : ImGuiDir_Right,
                                 ImVec2(step, step))) {
            touched.toggled = row.id;
        }
        ImGui::PopStyleVar();
        ImGui::PopStyleColor();
    }
    ImGui::SameLine();
    const bool selected = app.selection.node == row.id;
    if (show_label(label_of_node(scene, row.id), selected && app.selection.part == no_index,
                   false)) {
        touched.node = row.id;
        touched.is_double = ImGui::IsMouseDoubleClicked(0);
    }
}

void show_match(const App& app, std::uint32_t node, Touched& touched) {
    const Scene& scene = app.model->scene;
    if (show_label(label_of_node(scene, node), app.selection.node == node, false)) {
        touched.node = node;
        touched.is_double = ImGui::IsMouseDoubleClicked(0);
    }
    const std::uint32_t parent = scene.nodes[node].parent;
    if (parent != no_index) {
        ImGui::SameLine();
        ImGui::TextDisabled("%s", path_of(scene, parent).c_str());
    }
}

// The row of the selected part, or of its node where the part has none.
std::size_t selected_row(const App& app) {
    const std::vector<TreeRow>& rows = app.tree.rows();
    const auto found = std::find_if(rows.begin(), rows.end(), [&](const TreeRow& row) {
        return row.is_part ? row.id == app.selection.part
                           : app.selection.part == no_index && row.id == app.selection.node;
    });
    return static_cast<std::size_t>(found - rows.begin());
}

void scroll_to_selection(App& app) {
    if (!app.selection.scroll_tree || !app.search.text.empty()) {
        return;
    }
    app.selection.scroll_tree = false;
    const std::size_t row = selected_row(app);
    const float height = ImGui::GetTextLineHeightWithSpacing();
    const float y = height * static_cast<float>(row);
    const float top = ImGui::GetScrollY();
    if (row < app.tree.rows().size() && (y < top || y + height > top + ImGui::GetWindowHeight())) {
        ImGui::SetScrollY(std::max(0.0f, y - 0.4f * ImGui::GetWindowHeight()));
    }
}

Touched show_rows(const App& app) {
    Touched touched;
    const bool is_search = !app.search.text.empty();
    const std::size_t count = is_search ? app.search.nodes.size() : app.tree.rows().size();
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(count), ImGui::GetTextLineHeightWithSpacing());
    while (clipper.Step()) {
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            ImGui::PushID(i);
            const auto at = static_cast<std::size_t>(i);
            if (is_search) {
                show_match(app, app.search.nodes[at], touched);
            } else {
                show_row(app, app.tree.rows()[at], touched);
            }
            ImGui::PopID();
        }
    }
    return touched;
}

void apply(App& app, const Touched& touched) {
    if (touched.toggled != no_index) {
        app.tree.toggle(app.model->hierarchy, touched.toggled);
    }
    if (touched.part != no_index) {
        select_part(app, touched.part);
    }
    if (touched.node != no_index) {
        select_node(app, touched.node);
        if (!app.search.text.empty()) {
            app.tree.reveal(app.model->scene, app.model->hierarchy, touched.node, false);
            app.selection.scroll_tree = true;
        }
    }
    if (touched.is_double) {
        perform(app, Action::fit_selection);
    }
}

}  // namespace

void show_tree(App& app) {
    if (!app.model) {
        ImGui::TextDisabled("No model is open.");
        return;
    }
    ImGui::SetNextItemWidth(-1.0f);
    if (ImGui::InputTextWithHint("##search", "search names", &app.search.text)) {
        app.search.nodes = find_nodes(app.model->scene, app.search.text);
    }
    if (!app.search.text.empty()) {
        const std::string found = std::to_string(app.search.nodes.size()) + " found";
        ImGui::TextDisabled("%s", found.c_str());
    }
    ImGui::BeginChild("rows", ImVec2(0.0f, 0.0f), false, ImGuiWindowFlags_HorizontalScrollbar);
    scroll_to_selection(app);
    const Touched touched = show_rows(app);
    ImGui::EndChild();
    apply(app, touched);
}

}  // namespace quartic::viewer
