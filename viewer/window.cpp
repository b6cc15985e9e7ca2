// GLFW behind a small owner; errors become values.
#include "viewer/window.h"

#include <GLFW/glfw3.h>

#include <cctype>
#include <cstdlib>
#include <utility>

namespace quartic::viewer {

struct Window::Inbox {
    std::vector<Event> events;
    glm::dvec2 cursor{0.0};  // when the event happened; glfwGetCursorPos tells where it is by now
    bool stirred = true;
};

namespace {

constexpr PixelSize first_size{1400, 900};

std::string last_words() {
    const char* text = nullptr;
    glfwGetError(&text);
    return text != nullptr ? text : "no reason given";
}

Error no_display() {
    return {ErrorKind::no_opengl, "",
            "expected a display for a window, found none (" + last_words() +
                "); set DISPLAY, or use quartic render, which needs none"};
}

Error no_context() {
    return {ErrorKind::no_opengl, "",
            "expected a driver with OpenGL 4.5 core, found none (" + last_words() +
                "); install one, or try --software"};
}

// Letters move with the layout; other keys stay where they are.
int key_of_layout(int key, int scancode) {
    const char* const name = key < GLFW_KEY_SPACE || key > GLFW_KEY_GRAVE_ACCENT
                                 ? nullptr
                                 : glfwGetKeyName(key, scancode);
    if (name != nullptr && name[1] == '\0' &&
        std::isalpha(static_cast<unsigned char>(name[0])) != 0) {
        return std::toupper(static_cast<unsigned char>(name[0]));
    }
    return key;
}

}  // namespace

// Dear ImGui chains to these: they are installed before its own.
Window::Window(GLFWwindow* window) : window_(window), inbox_(new Inbox) {
    static const auto inbox = [](GLFWwindow* of) -> Inbox& {
        return *static_cast<Inbox*>(glfwGetWindowUserPointer(of));
    };
    static const auto add = [](GLFWwindow* of, Event event) {
        inbox(of).stirred = true;
        inbox(of).events.push_back(std::move(event));
    };
    glfwSetWindowUserPointer(window, inbox_);
    glfwSetMouseButtonCallback(window, [](GLFWwindow* of, int button, int action, int modifiers) {
        add(of, ButtonEvent{button, action == GLFW_PRESS, modifiers, inbox(of).cursor});
    });
    glfwSetCursorPosCallback(window, [](GLFWwindow* of, double x, double y) {
        inbox(of).cursor = {x, y};
        add(of, MoveEvent{{x, y}});
    });
    glfwSetScrollCallback(window, [](GLFWwindow* of, double, double notches) {
        add(of, WheelEvent{notches, inbox(of).cursor});
    });
    glfwSetKeyCallback(window,
                       [](GLFWwindow* of, int key, int scancode, int action, int modifiers) {
                           inbox(of).stirred = true;
                           if (action == GLFW_PRESS) {
                               add(of, KeyEvent{key_of_layout(key, scancode), modifiers});
                           }
                       });
    glfwSetCharCallback(
        window, [](GLFWwindow* of, unsigned character) { add(of, CharacterEvent{character}); });
    glfwSetDropCallback(window, [](GLFWwindow* of, int count, const char** paths) {
        for (int i = 0; i < count; ++i) {
            add(of, DropEvent{paths[i]});
        }
    });
    const auto stir = [](GLFWwindow* of) { inbox(of).stirred = true; };
    glfwSetWindowRefreshCallback(window, stir);
    glfwSetWindowCloseCallback(window, stir);
    glfwSetFramebufferSizeCallback(window,
                                   [](GLFWwindow* of, int, int) { inbox(of).stirred = true; });
    glfwSetWindowContentScaleCallback(
        window, [](GLFWwindow* of, float, float) { inbox(of).stirred = true; });
    glfwSetWindowFocusCallback(window, [](GLFWwindow* of, int) { inbox(of).stirred = true; });
}

Result<Window> Window::create(bool software) {
    if (software) {
        ::setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
    }
    if (glfwInit() != GLFW_TRUE) {
        return no_display();
    }
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 5);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
    glfwWindowHint(GLFW_DEPTH_BITS, 0);
    glfwWindowHint(GLFW_STENCIL_BITS, 0);
    GLFWwindow* const window =
        glfwCreateWindow(first_size.width, first_size.height, "Quartic", nullptr, nullptr);
    if (window == nullptr) {
        const Error error = no_context();
        glfwTerminate();
        return error;
    }
    glfwMakeContextCurrent(window);
    glfwSwapInterval(1);
    return Window(window);
}

Window::Window(Window&& other) noexcept
    : window_(std::exchange(other.window_, nullptr)),
      inbox_(std::exchange(other.inbox_, nullptr)) {}

Window::~Window() {
    if (window_ != nullptr) {
        glfwDestroyWindow(window_);
        glfwTerminate();
    }
    delete inbox_;
}

bool Window::wait(double seconds) {
    if (seconds > 0.0) {
        glfwWaitEventsTimeout(seconds);
    } else {
        glfwPollEvents();
    }
    return std::exchange(inbox_->stirred, false);
}

std::vector<Event> Window::take_events() {
    return std::exchange(inbox_->events, {});
}

PixelSize Window::size() const {
    PixelSize size;
    glfwGetWindowSize(window_, &size.width, &size.height);
    return size;
}

PixelSize Window::framebuffer() const {
    PixelSize size;
    glfwGetFramebufferSize(window_, &size.width, &size.height);
    return glfwGetWindowAttrib(window_, GLFW_ICONIFIED) == GLFW_TRUE ? PixelSize{} : size;
}

double Window::content_scale() const {
    float x = 1.0f;
    float y = 1.0f;
    glfwGetWindowContentScale(window_, &x, &y);
    // Where windows count in points, the framebuffer already has more pixels than the window.
    const double points = static_cast<double>(framebuffer().width) / std::max(size().width, 1);
    return std::max(static_cast<double>(x) / std::max(points, 1.0), 0.5);
}

bool Window::is_closing() const {
    return glfwWindowShouldClose(window_) == GLFW_TRUE;
}

void Window::close() {
    glfwSetWindowShouldClose(window_, GLFW_TRUE);
}

void Window::set_title(const std::string& title) {
    glfwSetWindowTitle(window_, title.c_str());
}

void Window::swap() {
    glfwSwapBuffers(window_);
}

void Window::wake() {
    glfwPostEmptyEvent();
}

}  // namespace quartic::viewer
