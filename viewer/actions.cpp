// What each action does.
#include "viewer/app.h"

#include "viewer/camera_control.h"

namespace quartic::viewer {
namespace {

// The innermost thing that can be closed; Esc never quits.
void cancel(App& app) {
    if (app.browser.is_open()) {
        app.browser.close();
    } else if (!app.failure.empty()) {
        app.failure.clear();
    } else if (app.panels.help) {
        app.panels.help = false;
    } else if (app.loading) {
        cancel_loading(app);
    } else {
        clear_selection(app);
    }
}

void flip_projection(App& app) {
    const Camera other = toggle_projection(app.camera);
    move_camera(app, other, glm::distance(other.eye, other.target));
}

}  // namespace

void perform(App& app, Action action) {
    switch (action) {
        case Action::fit_all: fit(app, app.shown_boxes); break;
        case Action::fit_selection:
            fit(app, app.selection.boxes.empty() ? app.shown_boxes : app.selection.boxes);
            break;
        case Action::view_front: fit(app, app.shown_boxes, "front"); break;
        case Action::view_back: fit(app, app.shown_boxes, "back"); break;
        case Action::view_right: fit(app, app.shown_boxes, "right"); break;
        case Action::view_left: fit(app, app.shown_boxes, "left"); break;
        case Action::view_top: fit(app, app.shown_boxes, "top"); break;
        case Action::view_bottom: fit(app, app.shown_boxes, "bottom"); break;
        case Action::view_iso: fit(app, app.shown_boxes, "iso"); break;
        case Action::toggle_projection: flip_projection(app); break;
        case Action::toggle_edges:
            app.options.edges = !app.options.edges;
            redraw_picture(app);
            break;
        case Action::toggle_occlusion:
            app.options.occlusion = !app.options.occlusion;
            redraw_picture(app);
            break;
        case Action::open_file:
            app.browser.open(app.model ? app.model->path : std::string());
            break;
        case Action::take_screenshot: app.screenshot_wanted = true; break;
        case Action::toggle_help: app.panels.help = !app.panels.help; break;
        case Action::cancel: cancel(app); break;
        case Action::quit: app.window.close(); break;
    }
}

}  // namespace quartic::viewer
