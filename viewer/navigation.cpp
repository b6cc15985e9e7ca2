// Turns events into motions of the camera, picks and actions.
#include "viewer/app.h"

#include "viewer/camera_control.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace quartic::viewer {
namespace {

constexpr double click_reach = 4.0;  // window coordinates at scale 1
constexpr double zoom_of_a_notch = 0.85;
constexpr double zoom_of_a_height = 0.1;  // of a drag over the whole height
constexpr double step_min = 2e-4;         // of the model's extent
constexpr double border = 6.0;            // panels are resized there

double extent_of(const App& app) {
    return app.shown_box.empty()
               ? 1.0
               : std::max(glm::distance(app.shown_box.low, app.shown_box.high), 1e-6);
}

// Pixels of the view from its lower left corner.
glm::dvec2 view_px(const App& app, const glm::dvec2& at) {
    const glm::dvec2 d = at - app.view.low;
    return {d.x * app.view.size_px.width / app.view.extent.x,
            (app.view.extent.y - d.y) * app.view.size_px.height / app.view.extent.y};
}

// Panels, menus and popups cover the model. What ImGui wants is a frame old: its windows are asked.
bool is_over_model(const App& app, const glm::dvec2& at) {
    const glm::dvec2 d = at - app.view.low;
    if (app.view.size_px.width < 1 || d.x < border || d.y < 0.0 ||
        d.x > app.view.extent.x - border || d.y > app.view.extent.y) {
        return false;
    }
    const ImGuiContext& context = *ImGui::GetCurrentContext();
    if (context.OpenPopupStack.Size > 0) {
        return false;
    }
    const ImVec2 point(static_cast<float>(at.x), static_cast<float>(at.y));
    return std::none_of(context.Windows.begin(), context.Windows.end(),
                        [&](const ImGuiWindow* window) {
                            return window->WasActive && !window->Hidden &&
                                   (window->Flags & ImGuiWindowFlags_NoMouseInputs) == 0 &&
                                   window->Rect().Contains(point);
                        });
}

// Where in the picture a place is; motions that came just before are drawn first.
glm::ivec2 drawn_px(App& app, const glm::dvec2& at) {
    if (app.picture.samples() == 0) {
        draw_sample(app);
    }
    return view_px(app, at) / static_cast<double>(app.picture.reduction());
}

std::optional<double> depth_under(App& app, const glm::dvec2& at) {
    if (!app.model) {
        return {};
    }
    const glm::ivec2 px = drawn_px(app, at);
    return app.renderer.depth_at(px.x, px.y);
}

// On the background: as far as what was looked at last, but never so near that motions stall.
double depth_or_guess(App& app, const glm::dvec2& at) {
    const double guess = glm::distance(app.camera.eye, app.camera.target);
    return depth_under(app, at).value_or(std::max(guess, 0.02 * extent_of(app)));
}

void pick(App& app, const glm::dvec2& at) {
    const glm::ivec2 px = drawn_px(app, at);
    select_part(app, app.model ? app.renderer.part_at(px.x, px.y) : no_index);
}

// Keys are keys again, at once: a slow picture may lie between two frames of Dear ImGui.
void leave_text() {
    ImGui::ClearActiveID();
    ImGui::GetIO().WantTextInput = false;
}

// Where the divider of a split view can be held.
bool is_at_divider(const App& app, const glm::dvec2& at) {
    const double place = app.view.low.x + app.maps.choice.divider * app.view.extent.x;
    return is_split(app) && std::abs(at.x - place) < border * app.scale;
}

void press(App& app, const ButtonEvent& event) {
    if (app.drag || !is_over_model(app, event.at)) {
        return;
    }
    if (event.button == 0 && is_at_divider(app, event.at)) {
        app.drag = Drag{event.button, {}, event.at, event.at, {}, true, true};
        return;
    }
    const std::optional<Gesture> gesture = find_gesture(event.button, event.modifiers);
    const std::optional<double> depth = depth_under(app, event.at);
    Drag drag{event.button, gesture, event.at, event.at, app.camera.target, false, false};
    if (depth) {
        drag.anchor = point_at(app.camera, app.view.size_px, view_px(app, event.at), *depth);
        app.camera = with_target_depth(app.camera, std::max(*depth, 1e-6 * extent_of(app)));
    }
    app.drag = drag;
    app.notice.clear();
    leave_text();
}

void release(App& app, const ButtonEvent& event) {
    if (!app.drag || app.drag->button != event.button) {
        return;
    }
    const bool is_click = !app.drag->moved && event.button == 0;
    app.drag.reset();
    if (is_click) {
        pick(app, event.at);
    }
}

double depth_of(const Camera& camera, const glm::dvec3& point) {
    return glm::dot(point - camera.eye, glm::normalize(camera.target - camera.eye));
}

void zoom_at(App& app, const glm::dvec2& at, double depth_m, double factor) {
    const double extent = extent_of(app);
    const Camera moved = zoom(app.camera, app.view.size_px, view_px(app, at), depth_m, factor,
                              {step_min * extent, 100.0 * extent});
    move_camera(app, moved, std::abs(depth_m * factor));
}

void drag_on(App& app, const glm::dvec2& at) {
    Drag& drag = *app.drag;
    if (drag.is_divider) {
        const double place = (at.x - app.view.low.x) / std::max(app.view.extent.x, 1.0);
        app.maps.choice.divider = std::clamp(place, 0.02, 0.98);
        return;
    }
    drag.moved = drag.moved || glm::distance(at, drag.start) > click_reach * app.scale;
    if (!drag.moved || !drag.gesture) {
        return;
    }
    const glm::dvec2 shift = (at - drag.last) / app.view.extent.y;
    const double depth = depth_of(app.camera, drag.anchor);
    if (*drag.gesture == Gesture::orbit) {
        const double turn = std::numbers::pi;
        move_camera(app, orbit(app.camera, drag.anchor, -turn * shift.x, -turn * shift.y), depth);
    } else if (*drag.gesture == Gesture::pan) {
        move_camera(
            app,
            pan(app.camera, app.view.size_px, view_px(app, drag.last), view_px(app, at), depth),
            depth);
    } else {
        zoom_at(app, drag.start, depth, std::pow(zoom_of_a_height, -shift.y));
    }
    drag.last = at;
}

void turn_wheel(App& app, const WheelEvent& event) {
    if (!app.drag && is_over_model(app, event.at)) {
        zoom_at(app, event.at, depth_or_guess(app, event.at),
                std::pow(zoom_of_a_notch, event.notches));
    }
}

// Esc closes what the user is in: a menu, then the text field with the search, then what cancel()
// finds.
void press_escape(App& app) {
    if (app.browser.is_open()) {
        leave_text();
    } else if (ImGui::GetCurrentContext()->OpenPopupStack.Size > 0) {
        ImGui::ClosePopupToLevel(0, false);
        return;
    } else if (ImGui::GetIO().WantTextInput) {
        leave_text();
        app.search = {};
        return;
    }
    perform(app, Action::cancel);
}

// A text field takes all keys but those that no text holds; the file browser leaves Esc and
// quitting.
void press_key(App& app, std::optional<Action> action, bool types_text) {
    if (action == Action::cancel) {
        press_escape(app);
    } else if (action && !(types_text && ImGui::GetIO().WantTextInput) &&
               (!app.browser.is_open() || action == Action::quit)) {
        perform(app, *action);
    }
}

struct Taker {
    App& app;

    void operator()(const ButtonEvent& event) const {
        app.cursor = event.at;
        event.pressed ? press(app, event) : release(app, event);
    }
    void operator()(const MoveEvent& event) const {
        app.cursor = event.at;
        if (app.drag) {
            drag_on(app, event.at);
        }
    }
    void operator()(const WheelEvent& event) const { turn_wheel(app, event); }
    void operator()(const KeyEvent& event) const {
        const std::optional<Action> action = find_action(event.key, event.modifiers);
        const bool types = action != Action::quit && action != Action::open_file &&
                           action != Action::take_screenshot;
        press_key(app, action, types);
    }
    void operator()(const CharacterEvent& event) const {
        press_key(app, find_action_of_character(event.character), true);
    }
    void operator()(const DropEvent& event) const { open_model(app, {event.path}); }
};

// Wheel notches that came while a picture was drawn are one motion: the depth is read once.
std::vector<Event> merge_notches(std::vector<Event> events) {
    std::vector<Event> merged;
    for (Event& event : events) {
        WheelEvent* const last = merged.empty() ? nullptr : std::get_if<WheelEvent>(&merged.back());
        const WheelEvent* const next = std::get_if<WheelEvent>(&event);
        if (last != nullptr && next != nullptr && last->at == next->at) {
            last->notches += next->notches;
        } else {
            merged.push_back(std::move(event));
        }
    }
    return merged;
}

}  // namespace

void take_events(App& app) {
    for (const Event& event : merge_notches(app.window.take_events())) {
        std::visit(Taker{app}, event);
    }
}

void look_under_cursor(App& app) {
    app.cursor_point.reset();
    if (is_over_model(app, app.cursor)) {
        if (const std::optional<double> depth = depth_under(app, app.cursor)) {
            app.cursor_point =
                point_at(app.camera, app.view.size_px, view_px(app, app.cursor), *depth);
        }
    }
}

}  // namespace quartic::viewer
