// All that the window knows, as plain values, and what can be done with it.
#pragma once

#include "render/context.h"
#include "render/renderer.h"
#include "scene/describe.h"
#include "viewer/bindings.h"
#include "viewer/file_browser.h"
#include "viewer/map_view.h"
#include "viewer/model.h"
#include "viewer/picture.h"
#include "viewer/window.h"

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace quartic::viewer {

// Where the model is shown, in the window's coordinates, and the same in pixels.
struct ViewArea {
    glm::dvec2 low{0.0};
    glm::dvec2 extent{0.0};
    PixelSize size_px;
};

// A part, or a node with all below it, or nothing.
struct Selection {
    std::uint32_t part = no_index;
    std::uint32_t node = no_index;
    std::vector<Box3> boxes;  // of its parts
    Box3 box;                 // around them
    std::vector<Property> properties;
    std::vector<Property> attributes;
    bool scroll_tree = false;  // to its row, once
};

// A button that is held down over the model.
struct Drag {
    int button = 0;
    std::optional<Gesture> gesture;
    glm::dvec2 start{0.0};  // window
    glm::dvec2 last{0.0};
    glm::dvec3 anchor{0.0};   // the point of the world that was under the cursor
    bool moved = false;       // else it is still a click
    bool is_divider = false;  // of a split view, not the camera
};

struct Search {
    std::string text;
    std::vector<std::uint32_t> nodes;
};

struct Panels {
    bool tree = true;
    bool properties = true;
    bool help = false;
    double tree_width = 320.0;  // window, at scale 1
    double properties_width = 360.0;
};

struct App {
    App(Window opened, Renderer made) : window(std::move(opened)), renderer(std::move(made)) {}

    Window window;
    Renderer renderer;
    RendererName renderer_is;
    Picture picture;
    Picture second_picture;  // right of the divider
    MapView maps{Window::wake};

    std::shared_ptr<Model> model;
    std::unique_ptr<Loading> loading;
    std::string start_camera;                     // for the first model
    int solver = 0;                               // of everything; 0: the materials' own
    std::vector<int> material_solvers;            // as chosen, for each material
    std::vector<int> drawn_solvers;               // as the renderer has them
    std::vector<std::uint32_t> solved_materials;  // of shapes with a choice of solvers
    int next_solver = 0;                          // of everything, once its programs are compiled
    std::optional<Packed> next_packed;            // waits for its programs too
    Worker<Packed> packing{Window::wake};

    Camera camera;
    RenderOptions options;
    std::vector<Box3> shown_boxes;  // of the parts on the layers that are shown
    Box3 shown_box;                 // around them
    ViewArea view;
    FrameCounts counts;

    Selection selection;
    TreeRows tree;
    Search search;
    Panels panels;
    FileBrowser browser;
    std::optional<Drag> drag;
    glm::dvec2 cursor{0.0};
    std::optional<glm::dvec3> cursor_point;  // in the world
    std::string notice;   // in the status bar, until something else is to be said
    std::string failure;  // in a window of its own, until it is closed
    bool screenshot_wanted = false;
    double scale = 1.0;  // of texts and widgets
};

void perform(App& app, Action action);

void open_model(App& app, std::vector<std::string> paths);
void cancel_loading(App& app);
// Takes over what the loading thread has finished, if it has.
void receive_model(App& app);
void change_solver(App& app, int solver);
// Packs the scene anew beside the window; until then the picture stays as it is.
void change_material_solver(App& app, std::uint32_t material, int solver);
// Takes solvers over whose programs are compiled, or compiles one more.
void advance_solvers(App& app);
bool is_changing_solvers(const App& app);
// Whether the programs are compiled; if not, one more of them is.
bool is_prepared(App& app, const RenderOptions& options);
std::string solver_name(const App& app, int solver);
void begin_solvers(App& app);  // of a model that was just opened
void change_layers(App& app);

void select_part(App& app, std::uint32_t part);
void select_node(App& app, std::uint32_t node);
void clear_selection(App& app);

// Looks from there with the near plane where it should be; interest_m is the depth of what is
// looked at.
void move_camera(App& app, const Camera& camera, double interest_m);
// Sees all of the boxes, from where the camera looks or as the name says.
void fit(App& app, std::span<const Box3> boxes, std::string_view view_name = {});

// Shown parts or solvers changed: draw again, pictures and maps.
void redraw(App& app);
// Only colours changed: maps stay.
void redraw_picture(App& app);
// Another map of the same picture.
void redraw_map(App& app);
// One more sample of the picture, unless it is complete.
void draw_sample(App& app);
bool is_drawn(const App& app);

// Mouse and keys in their order.
void take_events(App& app);
// What lies under the cursor.
void look_under_cursor(App& app);

void write_screenshot(App& app);

}  // namespace quartic::viewer
