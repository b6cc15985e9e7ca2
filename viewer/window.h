// The window, its OpenGL context and what the user does in it, as a list of events in order.
#pragma once

#include "diagnostics/result.h"
#include "scene/camera.h"

#include <glm/glm.hpp>

#include <string>
#include <variant>
#include <vector>

struct GLFWwindow;

namespace quartic::viewer {

// Positions in the window's own coordinates, y down; modifiers as GLFW has them.
struct ButtonEvent {
    int button = 0;
    bool pressed = false;
    int modifiers = 0;
    glm::dvec2 at{0.0};
};
struct MoveEvent {
    glm::dvec2 at{0.0};
};
struct WheelEvent {
    double notches = 0.0;
    glm::dvec2 at{0.0};
};
struct KeyEvent {
    int key = 0;  // letters as the keyboard's layout has them
    int modifiers = 0;
};
struct CharacterEvent {
    unsigned character = 0;
};
struct DropEvent {
    std::string path;
};
using Event = std::variant<ButtonEvent, MoveEvent, WheelEvent, KeyEvent, CharacterEvent, DropEvent>;

class Window {
public:
    // An OpenGL 4.5 core context, current on this thread. Kind no_opengl if there is no display or
    // no such context.
    static Result<Window> create(bool software);

    Window(Window&& other) noexcept;
    Window& operator=(Window&&) = delete;
    ~Window();

    // Waits at most this long for something to happen; 0 does not wait. Tells whether anything
    // happened.
    bool wait(double seconds);
    // What happened since the last call.
    std::vector<Event> take_events();

    PixelSize size() const;         // in the coordinates of the events
    PixelSize framebuffer() const;  // in pixels; 0 x 0 while minimised
    double content_scale() const;   // of texts; 1 on an ordinary screen
    bool is_closing() const;
    void close();
    void set_title(const std::string& title);
    void swap();
    GLFWwindow* handle() const { return window_; }

    // From any thread: ends a wait().
    static void wake();

private:
    explicit Window(GLFWwindow* window);
    GLFWwindow* window_ = nullptr;
    struct Inbox;
    Inbox* inbox_ = nullptr;  // GLFW's callbacks hold its address
};

}  // namespace quartic::viewer
