// The model's picture behind the panels, with lines over it.
#include "viewer/panels.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cstdint>

namespace quartic::viewer {
namespace {

ImVec2 screen_point(const glm::dvec2& p) {
    return {static_cast<float>(p.x), static_cast<float>(p.y)};
}

// Columns of the view, as parts of its width.
struct Columns {
    double from = 0.0;
    double to = 1.0;
};

void show_texture(const App& app, ImDrawList& list, unsigned texture, const Columns& columns,
                  int alpha) {
    const glm::dvec2& low = app.view.low;
    const glm::dvec2& extent = app.view.extent;
    list.AddImage(reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(texture)),
                  screen_point({low.x + columns.from * extent.x, low.y}),
                  screen_point({low.x + columns.to * extent.x, low.y + extent.y}),
                  ImVec2(static_cast<float>(columns.from), 1.0f),
                  ImVec2(static_cast<float>(columns.to), 0.0f), IM_COL32(255, 255, 255, alpha));
}

// Laid over one another with weights 1, 1/2, 1/3, ..., which make the mean of all.
void show_samples(const App& app, ImDrawList& list, const Picture& picture,
                  const Columns& columns) {
    for (int i = 0; i < picture.samples(); ++i) {
        show_texture(app, list, picture.texture(i), columns, (255 + (i + 1) / 2) / (i + 1));
    }
}

void show_half(const App& app, ImDrawList& list, bool is_second, const Columns& columns) {
    if (is_map_shown(app)) {
        const ShownMap& map = is_second ? app.maps.maps.back() : app.maps.maps.front();
        show_texture(app, list, map.texture.name(), columns, 255);
    } else {
        show_samples(app, list, is_second ? app.second_picture : app.picture, columns);
    }
}

// The line that parts the halves, with a grip in its middle.
void show_divider(const App& app, ImDrawList& list) {
    const double x = app.view.low.x + app.maps.choice.divider * app.view.extent.x;
    const double middle = app.view.low.y + 0.5 * app.view.extent.y;
    const double half = 14.0 * app.scale;
    const auto width = static_cast<float>(1.5 * app.scale);
    list.AddLine(screen_point({x + 1.0, app.view.low.y}),
                 screen_point({x + 1.0, app.view.low.y + app.view.extent.y}),
                 IM_COL32(255, 255, 255, 200), width);
    list.AddLine(screen_point({x, app.view.low.y}),
                 screen_point({x, app.view.low.y + app.view.extent.y}), IM_COL32(20, 20, 20, 255),
                 width);
    list.AddRectFilled(screen_point({x - 0.3 * half, middle - half}),
                       screen_point({x + 0.3 * half, middle + half}), IM_COL32(20, 20, 20, 255),
                       static_cast<float>(0.3 * half));
}

void show_halves(const App& app, ImDrawList& list) {
    if (!is_split(app)) {
        show_half(app, list, false, {0.0, 1.0});
        return;
    }
    show_half(app, list, false, {0.0, app.maps.choice.divider});
    show_half(app, list, true, {app.maps.choice.divider, 1.0});
    show_divider(app, list);
}

// A line between two points of the world, cut where it would come behind the eye.
void show_line(const App& app, ImDrawList& list, glm::dvec3 from, glm::dvec3 to, ImU32 colour) {
    const View view = make_view(app.camera, app.view.size_px);
    const auto depth = [&](const glm::dvec3& p) { return glm::dot(p - view.eye, -view.back); };
    if (view.projection == Projection::perspective) {
        const double nearest = view.near_m;
        const double a = depth(from);
        const double b = depth(to);
        if (a < nearest && b < nearest) {
            return;
        }
        if (a < nearest || b < nearest) {
            const glm::dvec3 cut = from + (nearest - a) / (b - a) * (to - from);
            (a < nearest ? from : to) = cut;
        }
    }
    const auto place = [&](const glm::dvec3& p) {
        const glm::dvec3 px = project(view, p);
        const double unit = app.view.extent.x / view.size.width;
        return screen_point(
            {app.view.low.x + px.x * unit, app.view.low.y + app.view.extent.y - px.y * unit});
    };
    list.AddLine(place(from), place(to), colour, static_cast<float>(1.5 * app.scale));
}

void show_box(const App& app, ImDrawList& list, const Box3& box) {
    const auto corner = [&](int i) {
        return glm::dvec3((i & 1) != 0 ? box.high.x : box.low.x,
                          (i & 2) != 0 ? box.high.y : box.low.y,
                          (i & 4) != 0 ? box.high.z : box.low.z);
    };
    for (int i = 0; i < 8; ++i) {
        for (const int axis : {1, 2, 4}) {
            if ((i & axis) == 0) {
                show_line(app, list, corner(i), corner(i | axis), IM_COL32(255, 170, 40, 220));
            }
        }
    }
}

// Where x, y and z point, in the lower left corner; the nearest axis is drawn last.
void show_axes(const App& app, ImDrawList& list) {
    struct Axis {
        const char* name;
        glm::dvec3 direction;
        ImU32 colour;
    };
    std::array<Axis, 3> axes{Axis{"x", {1, 0, 0}, IM_COL32(200, 60, 60, 255)},
                             Axis{"y", {0, 1, 0}, IM_COL32(50, 150, 60, 255)},
                             Axis{"z", {0, 0, 1}, IM_COL32(60, 90, 210, 255)}};
    const View view = make_view(app.camera, app.view.size_px);
    std::sort(axes.begin(), axes.end(), [&](const Axis& a, const Axis& b) {
        return glm::dot(a.direction, view.back) < glm::dot(b.direction, view.back);
    });
    const double length = 34.0 * app.scale;
    const glm::dvec2 centre =
        app.view.low + glm::dvec2(1.7 * length, app.view.extent.y - 1.7 * length);
    for (const Axis& axis : axes) {
        const glm::dvec2 across(glm::dot(axis.direction, view.right),
                                -glm::dot(axis.direction, view.up));
        const glm::dvec2 tip = centre + length * across;
        list.AddLine(screen_point(centre), screen_point(tip), axis.colour,
                     static_cast<float>(2.0 * app.scale));
        const ImVec2 half = ImGui::CalcTextSize(axis.name);
        const glm::dvec2 place =
            centre + 1.25 * length * across -
            0.5 * glm::dvec2(static_cast<double>(half.x), static_cast<double>(half.y));
        list.AddText(screen_point(place), axis.colour, axis.name);
    }
}

}  // namespace

void show_picture(const App& app) {
    if (app.view.size_px.width < 1 || app.view.size_px.height < 1) {
        return;
    }
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    list.PushClipRect(screen_point(app.view.low), screen_point(app.view.low + app.view.extent));
    show_halves(app, list);
    if (app.model) {
        if (app.selection.part == no_index && !app.selection.box.empty()) {
            show_box(app, list, app.selection.box);
        }
        show_axes(app, list);
    }
    list.PopClipRect();
}

}  // namespace quartic::viewer
