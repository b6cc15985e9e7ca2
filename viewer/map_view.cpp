// Makes maps of the view and keeps them until the view changes.
#include "viewer/map_view.h"

#include "viewer/app.h"

#include <epoxy/gl.h>

#include <algorithm>

namespace quartic::viewer {

// Made by the worker when it is first needed there.
struct Oracle {
    std::shared_ptr<const Model> model;
    std::array<bool, layer_count> layers{};
    std::unique_ptr<Reference> reference;
};

namespace {

// Costs are those of an ordinary frame; what is compared is drawn whole and opaque.
RenderOptions options_for(const App& app, MapKind kind, int solver) {
    RenderOptions options = app.options;
    options.solver = solver;
    options.inspect = kind == MapKind::steps || kind == MapKind::rays;
    options.opaque = !options.inspect;
    options.cull_size = options.inspect;
    return options;
}

// The first one's picture, and the second one's where it has a part.
std::vector<RenderOptions> looks_for(const App& app, MapKind kind) {
    std::vector<RenderOptions> looks{options_for(app, kind, app.solver)};
    if (is_split(app) || kind == MapKind::difference) {
        looks.push_back(options_for(app, kind, app.maps.choice.second));
    }
    return looks;
}

bool are_prepared(App& app, MapKind kind) {
    const std::vector<RenderOptions> looks = looks_for(app, kind);
    return std::all_of(looks.begin(), looks.end(),
                       [&](const RenderOptions& options) { return is_prepared(app, options); });
}

// The second picture is drawn first, so that the renderer keeps the first one for picking.
Result<std::vector<GBuffer>> draw_pictures(App& app, MapKind kind) {
    const std::vector<RenderOptions> looks = looks_for(app, kind);
    std::vector<GBuffer> pictures(looks.size());
    for (std::size_t i = looks.size(); i-- > 0;) {
        const Status drawn = app.renderer.draw(app.camera, app.view.size_px, looks[i]);
        if (!drawn) {
            return drawn.error();
        }
        pictures[i] = app.renderer.read();
    }
    return pictures;
}

std::vector<Map> maps_of(const App& app, MapKind kind, const std::vector<GBuffer>& pictures) {
    const View view = make_view(app.camera, app.view.size_px);
    if (kind == MapKind::difference) {
        return {
            difference_map(view, {picture_of(pictures[0]), solver_name(app, app.solver)},
                           {picture_of(pictures[1]), solver_name(app, app.maps.choice.second)})};
    }
    std::vector<Map> maps;
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        const GBuffer& picture = pictures[i];
        if (kind == MapKind::solver) {
            maps.push_back(solver_map(app.model->scene, picture_of(picture),
                                      i == 0 ? app.solver : app.maps.choice.second,
                                      app.drawn_solvers));
        } else {
            maps.push_back(count_map(kind, picture.size,
                                     kind == MapKind::steps ? picture.steps : picture.rays,
                                     picture.rays));
        }
    }
    return maps;
}

void begin_errors(App& app, std::vector<GBuffer> pictures) {
    std::shared_ptr<Oracle>& oracle = app.maps.oracle;
    if (!oracle || oracle->model != app.model || oracle->layers != app.options.layers) {
        oracle = std::make_shared<Oracle>(Oracle{app.model, app.options.layers, nullptr});
    }
    const auto given = std::make_shared<std::vector<GBuffer>>(std::move(pictures));
    const View view = make_view(app.camera, app.view.size_px);
    app.maps.worker.begin([oracle, given, view](const Stop& stop) {
        if (!oracle->reference) {
            oracle->reference =
                std::make_unique<Reference>(oracle->model->scene, oracle->layers, solver_default);
        }
        std::vector<Map> maps;
        for (const GBuffer& picture : *given) {
            maps.push_back(error_map(*oracle->reference, view, picture_of(picture), stop));
        }
        return maps;
    });
}

// One scale for all, so that halves can be compared.
MapScale scale_of_all(const std::vector<Map>& maps) {
    MapScale scale = scale_of(maps.front());
    for (const Map& map : maps) {
        const MapScale own = scale_of(map);
        scale.low = std::min(scale.low, own.low);
        scale.high = std::max(scale.high, own.high);
    }
    return scale;
}

void show_maps(App& app, const std::vector<Map>& maps) {
    MapView& view = app.maps;
    const MapScale scale = scale_of_all(maps);
    view.maps.clear();
    view.size = maps.front().size;
    for (const Map& map : maps) {
        ShownMap shown;
        shown.legend = legend_of(map, scale);
        shown.rgba = colours_of(map, scale);
        shown.texture = make_texture(GL_RGBA8, view.size.width, view.size.height);
        glTextureSubImage2D(shown.texture.name(), 0, 0, 0, view.size.width, view.size.height,
                            GL_RGBA, GL_UNSIGNED_BYTE, shown.rgba.data());
        view.maps.push_back(std::move(shown));
    }
    view.shown = view.begun;
}

void take_errors(App& app) {
    const std::optional<Result<std::vector<Map>>> made = app.maps.worker.take();
    if (!made || app.maps.begun != app.maps.wanted) {
        return;
    }
    if (*made) {
        show_maps(app, made->value());
    } else {
        app.failure = made->error().message;
    }
}

void begin_map(App& app, MapKind kind) {
    app.maps.begun = app.maps.wanted;
    Result<std::vector<GBuffer>> pictures = draw_pictures(app, kind);
    if (!pictures) {
        app.failure = pictures.error().message;
    } else if (kind == MapKind::error) {
        begin_errors(app, std::move(pictures).value());
    } else {
        show_maps(app, maps_of(app, kind, pictures.value()));
    }
}

}  // namespace

bool is_split(const App& app) {
    return app.maps.choice.is_split && app.maps.choice.kind != MapKind::difference;
}

bool is_map_shown(const App& app) {
    return app.maps.choice.kind.has_value() && app.maps.shown == app.maps.wanted;
}

bool is_map_awaited(const App& app) {
    return app.model && app.maps.choice.kind.has_value() && !is_map_shown(app);
}

bool is_map_preparing(const App& app) {
    return is_map_awaited(app) && app.maps.begun != app.maps.wanted && !app.drag && is_drawn(app) &&
           app.view.size_px.width > 0 && app.view.size_px.height > 0;
}

bool advance_map(App& app) {
    const std::uint64_t before = app.maps.shown;
    take_errors(app);
    if (is_map_preparing(app) && are_prepared(app, *app.maps.choice.kind)) {
        begin_map(app, *app.maps.choice.kind);
    }
    return app.maps.shown != before;
}

std::vector<std::uint8_t> seen_pixels(const App& app) {
    const bool is_map = is_map_shown(app);
    std::vector<std::uint8_t> left = is_map ? app.maps.maps.front().rgba : app.picture.read();
    if (!is_split(app)) {
        return left;
    }
    const std::vector<std::uint8_t> right =
        is_map ? app.maps.maps.back().rgba : app.second_picture.read();
    const PixelSize size = is_map ? app.maps.size : app.picture.size_px();
    const int divider = static_cast<int>(app.maps.choice.divider * size.width);
    for (int y = 0; y < size.height; ++y) {
        const auto from = static_cast<std::ptrdiff_t>(4 * pixel_index(size, divider, y));
        const auto end = static_cast<std::ptrdiff_t>(4 * pixel_index(size, 0, y + 1));
        std::copy(right.begin() + from, right.begin() + end, left.begin() + from);
    }
    return left;
}

}  // namespace quartic::viewer
