// Opening, selecting, fitting: what menus, keys and panels have in common.
#include "viewer/app.h"

#include "viewer/camera_control.h"

#include <utility>

namespace quartic::viewer {
namespace {

constexpr double slow_ms = 100.0;  // a picture that takes longer is drawn coarser while it moves

std::vector<Property> attributes_of(const Scene& scene, std::uint32_t node) {
    std::vector<Property> list;
    const Node& owner = scene.nodes[node];
    for (std::uint32_t i = 0; i < owner.attribute_count; ++i) {
        const Attribute& attribute = scene.attributes[owner.first_attribute + i];
        list.push_back({std::string(scene.strings[attribute.key]),
                        std::string(scene.strings[attribute.value])});
    }
    return list;
}

std::vector<Property> describe_node(const Model& model, std::uint32_t node, const Box3& box) {
    const Scene& scene = model.scene;
    std::vector<Property> list{{"Path", path_of(scene, node)},
                               {"Name", std::string(scene.strings[scene.nodes[node].name])},
                               {"Children", std::to_string(model.hierarchy.children(node).size())},
                               {"Parts", std::to_string(model.hierarchy.parts(node).size())},
                               {"Position", position_text(scene.nodes[node].position)}};
    if (!box.empty()) {
        const glm::dvec3 extent = box.high - box.low;
        list.push_back({"Extent", length_text(extent.x) + " x " + length_text(extent.y) + " x " +
                                      length_text(extent.z)});
    }
    return list;
}

// The title is what other programs, and people with many windows, see of the selection.
void name_window(App& app) {
    std::string title;
    if (app.model && app.selection.node != no_index) {
        const Scene& scene = app.model->scene;
        title = std::string(scene.strings[scene.nodes[app.selection.node].name]);
        if (app.selection.part != no_index) {
            title += " (" + spoken(name(scene.parts[app.selection.part].type)) + ")";
        }
        title += " - ";
    }
    if (app.model) {
        title += file_name(app.model->path) + " - ";
    }
    app.window.set_title(title + "Quartic");
}

void select(App& app, std::uint32_t part, std::uint32_t node) {
    const Model& model = *app.model;
    Selection selection;
    selection.part = part;
    selection.node = node;
    if (part != no_index) {
        selection.boxes = {world_bounds(model.scene, model.scene.parts[part])};
    } else {
        selection.boxes = boxes_of_node(model.scene, model.hierarchy, node);
    }
    selection.box = around(selection.boxes);
    selection.properties =
        part != no_index ? describe(model.scene, part) : describe_node(model, node, selection.box);
    selection.attributes = attributes_of(model.scene, node);
    app.selection = std::move(selection);
    app.options.selected = part;
    name_window(app);
    redraw_picture(app);
}

void measure_shown(App& app) {
    app.shown_boxes.clear();
    for (const Part& part : app.model->scene.parts) {
        if (app.options.layers[static_cast<std::size_t>(part.layer)]) {
            app.shown_boxes.push_back(world_bounds(app.model->scene, part));
        }
    }
    app.shown_box = around(app.shown_boxes);
}

Status show_model(App& app, std::shared_ptr<Model> model) {
    const Status uploaded = app.renderer.load(model->packed);
    if (!uploaded) {
        return uploaded;
    }
    model->packed = {};
    app.model = std::move(model);
    app.tree = TreeRows(app.model->scene, app.model->hierarchy);
    app.search = {};
    app.notice.clear();
    begin_solvers(app);
    measure_shown(app);
    clear_selection(app);
    fit(app, app.shown_boxes, app.start_camera.empty() ? "fit" : app.start_camera);
    app.start_camera.clear();
    return Done{};
}

void report_failure(App& app, const Error& error) {
    app.failure = error.where.empty() ? error.message : error.where + ": " + error.message;
}

}  // namespace

void redraw(App& app) {
    redraw_map(app);
    redraw_picture(app);
}

void redraw_picture(App& app) {
    app.picture.discard();
    app.second_picture.discard();
}

void redraw_map(App& app) {
    ++app.maps.wanted;
    app.maps.worker.cancel();
}

bool is_drawn(const App& app) {
    return app.picture.is_complete() && (!is_split(app) || app.second_picture.is_complete());
}

void draw_sample(App& app) {
    const PixelSize size = app.view.size_px;
    if (is_drawn(app) || size.width < 1 || size.height < 1) {
        return;
    }
    const bool is_moving = app.drag && app.drag->moved;
    const bool is_slow = app.picture.draw_ms() * app.picture.reduction() > slow_ms;
    const int reduction = is_moving && is_slow ? 2 : 1;
    RenderOptions options = app.options;
    const auto draw = [&](Picture& picture) {
        const Status drawn = picture.draw(app.renderer, app.camera, size, options, reduction);
        if (!drawn) {
            app.failure = drawn.error().message;
        }
    };
    options.solver = app.maps.choice.second;
    if (is_split(app) && !app.second_picture.is_complete() && is_prepared(app, options)) {
        draw(app.second_picture);
    }
    options.solver = app.solver;
    if (!app.picture.is_complete()) {
        draw(app.picture);
    }
    app.counts = app.renderer.counts();
    if (!app.renderer.gl_errors().empty()) {
        app.notice = "The driver complained: " + app.renderer.gl_errors().front();
    }
}

void open_model(App& app, std::vector<std::string> paths) {
    app.loading.reset();  // the one before is cancelled
    app.failure.clear();
    app.loading = std::make_unique<Loading>(std::move(paths));
}

void cancel_loading(App& app) {
    app.loading.reset();
    app.notice = "Opening was cancelled.";
}

void receive_model(App& app) {
    // The first frame decides how large the view is, which the first camera needs.
    if (!app.loading || !app.loading->is_finished() || app.view.size_px.width < 1) {
        return;
    }
    Result<std::unique_ptr<Model>> loaded = app.loading->take();
    app.loading.reset();
    if (!loaded) {
        report_failure(app, loaded.error());
        return;
    }
    const Status shown = show_model(app, std::move(loaded).value());
    if (!shown) {
        report_failure(app, shown.error());
    }
}

void change_layers(App& app) {
    if (app.model) {
        measure_shown(app);
    }
    redraw(app);
}

void select_part(App& app, std::uint32_t part) {
    if (!app.model || part >= app.model->scene.parts.size()) {
        clear_selection(app);
        return;
    }
    const Model& model = *app.model;
    const std::uint32_t node = model.scene.parts[part].node;
    select(app, part, node);
    app.tree.reveal(model.scene, model.hierarchy, node, true);
    app.selection.scroll_tree = true;
}

void select_node(App& app, std::uint32_t node) {
    const std::span<const std::uint32_t> parts = app.model->hierarchy.parts(node);
    const bool is_one_part = parts.size() == 1 && app.model->hierarchy.children(node).empty();
    select(app, is_one_part ? parts.front() : no_index, node);
}

void clear_selection(App& app) {
    app.selection = {};
    app.options.selected = no_index;
    name_window(app);
    redraw_picture(app);
}

void move_camera(App& app, const Camera& camera, double interest_m) {
    app.camera = with_near_plane(camera, app.shown_box, interest_m);
    redraw(app);
}

void fit(App& app, std::span<const Box3> boxes, std::string_view view_name) {
    const PixelSize size = app.view.size_px.width > 0 ? app.view.size_px : PixelSize{1200, 800};
    std::optional<Camera> camera;
    if (!view_name.empty()) {
        camera = find_camera(view_name, boxes, app.camera, size);
        if (!camera) {
            app.notice = "The camera \"" + std::string(view_name) + "\" is not known.";
        }
    }
    if (!camera) {
        camera =
            fit_camera(boxes, app.camera.target - app.camera.eye, app.camera.up, app.camera, size);
    }
    move_camera(app, *camera, glm::distance(camera->eye, camera->target));
}

}  // namespace quartic::viewer
