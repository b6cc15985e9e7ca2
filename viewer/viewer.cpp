// Opens the window and runs its loop: wait, take events, draw what changed.
#include "viewer/viewer.h"

#include "files/source.h"
#include "viewer/panels.h"
#include "viewer/theme.h"

#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <epoxy/gl.h>
#include <imgui.h>

namespace quartic::viewer {
namespace {

constexpr int frames_to_settle = 3;  // Dear ImGui shows some effects a frame or two later
constexpr double wait_loading_s = 0.05;
constexpr double wait_typing_s = 0.25;  // the caret blinks
constexpr double wait_idle_s = 5.0;

// Dear ImGui and its two backends; the window and its context must live longer.
class Gui {
public:
    explicit Gui(const Window& window) {
        ImGui::CreateContext();
        ImGuiIO& io = ImGui::GetIO();
        io.IniFilename = nullptr;  // leaves no file in the user's folder
        io.ConfigWindowsMoveFromTitleBarOnly = true;
        ImGui_ImplGlfw_InitForOpenGL(window.handle(), true);
        ImGui_ImplOpenGL3_Init("#version 450");
    }
    ~Gui() {
        ImGui_ImplOpenGL3_Shutdown();
        ImGui_ImplGlfw_Shutdown();
        ImGui::DestroyContext();
    }
    Gui(const Gui&) = delete;
    Gui& operator=(const Gui&) = delete;
};

void follow_scale(App& app) {
    const double scale = app.window.content_scale();
    if (scale != app.scale || !ImGui::GetIO().Fonts->IsBuilt()) {
        app.scale = scale;
        apply_theme(scale);
        ImGui_ImplOpenGL3_DestroyFontsTexture();
    }
}

void show_frame(App& app) {
    follow_scale(app);
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    ImGui::NewFrame();
    show_panels(app);
    ImGui::Render();
    const PixelSize size = app.window.framebuffer();
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, size.width, size.height);
    glClearColor(0.2f, 0.2f, 0.2f, 1.0f);
    glClear(GL_COLOR_BUFFER_BIT);
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    app.window.swap();
}

double patience(const App& app, int frames_left) {
    const bool can_draw = app.view.size_px.width > 0 && app.view.size_px.height > 0;
    if (frames_left > 0 || (can_draw && !is_drawn(app)) || is_changing_solvers(app) ||
        is_map_preparing(app)) {
        return 0.0;
    }
    if (app.loading) {
        return wait_loading_s;
    }
    return ImGui::GetIO().WantTextInput ? wait_typing_s : wait_idle_s;
}

// Whether what is seen will stay as it is.
bool is_settled(const App& app) {
    return !app.model || (is_drawn(app) && !is_map_awaited(app) && !is_changing_solvers(app));
}

bool is_minimised(const App& app) {
    return app.window.framebuffer().width < 1 || app.window.framebuffer().height < 1;
}

void run(App& app) {
    int frames_left = frames_to_settle;
    while (!app.window.is_closing()) {
        const double wait_s = is_minimised(app) ? wait_idle_s : patience(app, frames_left);
        if (app.window.wait(wait_s)) {
            frames_left = frames_to_settle;
        }
        take_events(app);
        receive_model(app);
        advance_solvers(app);
        if (is_minimised(app)) {
            continue;
        }
        draw_sample(app);
        if (advance_map(app)) {
            frames_left = frames_to_settle;
        }
        if (app.screenshot_wanted && is_settled(app)) {
            write_screenshot(app);
        }
        look_under_cursor(app);
        show_frame(app);
        frames_left = std::max(0, frames_left - 1);
    }
}

}  // namespace
}  // namespace quartic::viewer

namespace quartic {

Result<int> run_viewer(const ViewerOptions& options) {
    for (const std::string& file : options.files) {
        const Result<Source> source = Source::open(file);
        if (!source) {
            return source.error();  // before a window flashes up
        }
    }
    Result<viewer::Window> window = viewer::Window::create(options.software);
    if (!window) {
        return window.error();
    }
    const Status usable = check_context();
    if (!usable) {
        return usable.error();
    }
    Result<Renderer> renderer = Renderer::create();
    if (!renderer) {
        return renderer.error();
    }
    viewer::App app(std::move(window).value(), std::move(renderer).value());
    app.renderer_is = renderer_name();
    app.start_camera = options.camera;
    app.solver = options.solver;
    app.next_solver = options.solver;
    const viewer::Gui gui(app.window);  // ends before the window does
    if (!options.files.empty()) {
        viewer::open_model(app, options.files);
    }
    viewer::run(app);
    return 0;
}

}  // namespace quartic
