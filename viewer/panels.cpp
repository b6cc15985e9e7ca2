// The layout of the window: menu above, tree left, properties right, status below.
#include "viewer/panels.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

namespace quartic::viewer {
namespace {

constexpr ImGuiWindowFlags panel_flags =
    ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoTitleBar |
    ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus;
constexpr double panel_min = 160.0;

struct Strip {
    double top = 0.0;
    double height = 0.0;
};

struct Widths {
    double least;
    double most;
};

Widths panel_widths(double scale) {
    const double most = std::max(0.4 * static_cast<double>(ImGui::GetIO().DisplaySize.x), 1.0);
    return {std::min(panel_min * scale, most), most};
}

// In the window's coordinates, for the width that the user chose.
double panel_width(double width, double scale) {
    const Widths widths = panel_widths(scale);
    return std::clamp(width * scale, widths.least, widths.most);
}

// Opens a panel whose inner side the user can drag. Its width is kept, but not what a narrow window
// makes of it.
bool begin_panel(const char* name, bool at_right, const Strip& strip, double& width, double scale) {
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const Widths widths = panel_widths(scale);
    const auto wide = static_cast<float>(panel_width(width, scale));
    const auto high = static_cast<float>(strip.height);
    ImGui::SetNextWindowPos(
        ImVec2(at_right ? display.x - wide : 0.0f, static_cast<float>(strip.top)));
    ImGui::SetNextWindowSizeConstraints(ImVec2(static_cast<float>(widths.least), high),
                                        ImVec2(static_cast<float>(widths.most), high));
    ImGui::SetNextWindowSize(ImVec2(wide, high));
    const bool is_shown = ImGui::Begin(name, nullptr, panel_flags);
    const double dragged = static_cast<double>(ImGui::GetWindowWidth() - wide);
    if (std::abs(dragged) >= 1.0) {
        width = static_cast<double>(ImGui::GetWindowWidth()) / scale;
    }
    return is_shown;
}

void show_left(App& app, const Strip& strip) {
    if (begin_panel("Tree", false, strip, app.panels.tree_width, app.scale)) {
        show_tree(app);
    }
    ImGui::End();
}

void show_right(App& app, const Strip& strip) {
    if (begin_panel("Properties", true, strip, app.panels.properties_width, app.scale) &&
        ImGui::BeginTabBar("tabs")) {
        if (ImGui::BeginTabItem("Properties")) {
            show_properties(app);
            ImGui::EndTabItem();
        }
        if (ImGui::BeginTabItem("Import report")) {
            if (app.model) {
                show_import_report(*app.model);
            } else {
                ImGui::TextDisabled("No model is open.");
            }
            ImGui::EndTabItem();
        }
        ImGui::EndTabBar();
    }
    ImGui::End();
}

// What the panels leave; a changed size needs a new picture.
void place_view(App& app, const Strip& strip) {
    const ImGuiIO& io = ImGui::GetIO();
    const double left = app.panels.tree ? panel_width(app.panels.tree_width, app.scale) : 0.0;
    const double right =
        app.panels.properties ? panel_width(app.panels.properties_width, app.scale) : 0.0;
    app.view.low = {left, strip.top};
    app.view.extent = {std::max(static_cast<double>(io.DisplaySize.x) - left - right, 0.0),
                       std::max(strip.height, 0.0)};
    const PixelSize size{
        static_cast<int>(app.view.extent.x * static_cast<double>(io.DisplayFramebufferScale.x)),
        static_cast<int>(app.view.extent.y * static_cast<double>(io.DisplayFramebufferScale.y))};
    if (size.width != app.view.size_px.width || size.height != app.view.size_px.height) {
        app.view.size_px = size;
        redraw(app);
    }
}

}  // namespace

void show_panels(App& app) {
    show_picture(app);
    show_menu_bar(app);
    show_status_bar(app);
    const double bar = static_cast<double>(ImGui::GetFrameHeight());
    const Strip strip{bar, static_cast<double>(ImGui::GetIO().DisplaySize.y) - 2.0 * bar};
    if (strip.height > 0.0) {
        if (app.panels.tree) {
            show_left(app, strip);
        }
        if (app.panels.properties) {
            show_right(app, strip);
        }
    }
    show_legends(app);
    show_help(app);
    show_loading(app);
    show_failure(app);
    if (const std::optional<std::string> chosen = app.browser.show(app.scale)) {
        open_model(app, {*chosen});
    }
    place_view(app, strip);
}

}  // namespace quartic::viewer
