// The one table of keys and mouse gestures: it drives the window and the help.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace quartic::viewer {

enum class Action {
    fit_all,
    fit_selection,
    view_front,
    view_back,
    view_right,
    view_left,
    view_top,
    view_bottom,
    view_iso,
    toggle_projection,
    toggle_edges,
    toggle_occlusion,
    open_file,
    take_screenshot,
    toggle_help,
    cancel,
    quit,
};

enum class Gesture { orbit, pan, zoom };

struct KeyBinding {
    Action action;
    int key;  // GLFW's number, letters as the keyboard's layout has them; 0: character decides
    int modifiers = 0;   // exactly these of Shift and Ctrl
    char character = 0;  // what the key types, where layouts differ too much
};

struct ActionRow {
    Action action;
    std::string_view text;
};

struct GestureRow {
    Gesture gesture;
    int button;  // GLFW's number
    int modifiers;
    std::string_view keys;
    std::string_view text;
};

std::span<const ActionRow> action_table();
std::span<const GestureRow> gesture_table();
// The wheel and the click have no choice, but the help names them.
std::span<const GestureRow> fixed_gestures();

std::optional<Action> find_action(int key, int modifiers);
std::optional<Action> find_action_of_character(unsigned character);
std::optional<Gesture> find_gesture(int button, int modifiers);

// "F", "Shift+F", or "F1, H, ?": every way to ask for an action.
std::string keys_of(Action action);
// The first of them, for menus.
std::string first_key_of(Action action);
std::string_view text_of(Action action);

}  // namespace quartic::viewer
