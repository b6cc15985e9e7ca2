// Keys and gestures as rows.
#include "viewer/bindings.h"

#include <GLFW/glfw3.h>

#include <array>

namespace quartic::viewer {
namespace {

constexpr int ctrl = GLFW_MOD_CONTROL;
constexpr int shift = GLFW_MOD_SHIFT;

constexpr auto keys = std::to_array<KeyBinding>({
    {Action::fit_all, GLFW_KEY_F},
    {Action::fit_all, GLFW_KEY_HOME},
    {Action::fit_selection, GLFW_KEY_F, shift},
    {Action::view_front, GLFW_KEY_1},
    {Action::view_front, GLFW_KEY_KP_1},
    {Action::view_back, GLFW_KEY_1, ctrl},
    {Action::view_back, GLFW_KEY_KP_1, ctrl},
    {Action::view_right, GLFW_KEY_3},
    {Action::view_right, GLFW_KEY_KP_3},
    {Action::view_left, GLFW_KEY_3, ctrl},
    {Action::view_left, GLFW_KEY_KP_3, ctrl},
    {Action::view_top, GLFW_KEY_7},
    {Action::view_top, GLFW_KEY_KP_7},
    {Action::view_bottom, GLFW_KEY_7, ctrl},
    {Action::view_bottom, GLFW_KEY_KP_7, ctrl},
    {Action::view_iso, GLFW_KEY_9},
    {Action::view_iso, GLFW_KEY_KP_9},
    {Action::toggle_projection, GLFW_KEY_5},
    {Action::toggle_projection, GLFW_KEY_KP_5},
    {Action::toggle_edges, GLFW_KEY_E},
    {Action::toggle_occlusion, GLFW_KEY_A},
    {Action::open_file, GLFW_KEY_O, ctrl},
    {Action::take_screenshot, GLFW_KEY_F12},
    {Action::toggle_help, GLFW_KEY_F1},
    {Action::toggle_help, GLFW_KEY_H},
    {Action::toggle_help, 0, 0, '?'},
    {Action::cancel, GLFW_KEY_ESCAPE},
    {Action::quit, GLFW_KEY_Q, ctrl},
});

constexpr auto actions = std::to_array<ActionRow>({
    {Action::fit_all, "Fit all"},
    {Action::fit_selection, "Fit selection"},
    {Action::view_front, "Front view"},
    {Action::view_back, "Back view"},
    {Action::view_right, "Right view"},
    {Action::view_left, "Left view"},
    {Action::view_top, "Top view"},
    {Action::view_bottom, "Bottom view"},
    {Action::view_iso, "Isometric view"},
    {Action::toggle_projection, "Orthographic"},
    {Action::toggle_edges, "Edges"},
    {Action::toggle_occlusion, "Ambient occlusion"},
    {Action::open_file, "Open..."},
    {Action::take_screenshot, "Screenshot"},
    {Action::toggle_help, "Keys and mouse"},
    {Action::cancel, "Clear selection, close what is open"},
    {Action::quit, "Quit"},
});

constexpr auto gestures = std::to_array<GestureRow>({
    {Gesture::orbit, GLFW_MOUSE_BUTTON_LEFT, 0, "Left drag",
     "Orbit about the point under the cursor"},
    {Gesture::pan, GLFW_MOUSE_BUTTON_MIDDLE, 0, "Middle drag", "Pan"},
    {Gesture::pan, GLFW_MOUSE_BUTTON_LEFT, shift, "Shift+left drag", "Pan"},
    {Gesture::zoom, GLFW_MOUSE_BUTTON_RIGHT, 0, "Right drag", "Zoom at the point under the cursor"},
});

constexpr auto fixed = std::to_array<GestureRow>({
    {Gesture::zoom, 0, 0, "Wheel", "Zoom to the cursor, through walls too"},
    {Gesture::orbit, 0, 0, "Click", "Select a part; on the background: nothing"},
});

std::string name_of_key(const KeyBinding& binding) {
    std::string text = (binding.modifiers & ctrl) != 0 ? "Ctrl+" : "";
    text += (binding.modifiers & shift) != 0 ? "Shift+" : "";
    const int key = binding.key;
    if (key == 0) {
        return text + binding.character;
    }
    if (key >= GLFW_KEY_F1 && key <= GLFW_KEY_F25) {
        return text + "F" + std::to_string(key - GLFW_KEY_F1 + 1);
    }
    if (key >= GLFW_KEY_KP_0 && key <= GLFW_KEY_KP_9) {
        return text + "Pad " + std::to_string(key - GLFW_KEY_KP_0);
    }
    switch (key) {
        case GLFW_KEY_ESCAPE: return text + "Esc";
        case GLFW_KEY_HOME: return text + "Home";
        default: return text + static_cast<char>(key);
    }
}

}  // namespace

std::span<const ActionRow> action_table() {
    return actions;
}

std::span<const GestureRow> gesture_table() {
    return gestures;
}

std::span<const GestureRow> fixed_gestures() {
    return fixed;
}

std::optional<Action> find_action(int key, int modifiers) {
    for (const KeyBinding& binding : keys) {
        if (binding.key != 0 && binding.key == key &&
            binding.modifiers == (modifiers & (ctrl | shift))) {
            return binding.action;
        }
    }
    return {};
}

std::optional<Action> find_action_of_character(unsigned character) {
    for (const KeyBinding& binding : keys) {
        if (binding.key == 0 && static_cast<unsigned char>(binding.character) == character) {
            return binding.action;
        }
    }
    return {};
}

std::optional<Gesture> find_gesture(int button, int modifiers) {
    for (const GestureRow& row : gestures) {
        if (row.button == button && row.modifiers == (modifiers & (ctrl | shift))) {
            return row.gesture;
        }
    }
    return {};
}

std::string keys_of(Action action) {
    std::string text;
    for (const KeyBinding& binding : keys) {
        if (binding.action == action) {
            text += (text.empty() ? "" : ", ") + name_of_key(binding);
        }
    }
    return text;
}

std::string first_key_of(Action action) {
    const std::string all = keys_of(action);
    return all.substr(0, all.find(','));
}

std::string_view text_of(Action action) {
    for (const ActionRow& row : actions) {
        if (row.action == action) {
            return row.text;
        }
    }
    return {};
}

}  // namespace quartic::viewer
