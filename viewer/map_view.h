// What is shown instead of the model's picture: maps of what the solvers did, and two solvers side
// by side.
#pragma once

#include "render/gl_objects.h"
#include "scene/map_picture.h"
#include "solvers/solver_table.h"
#include "viewer/worker.h"

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace quartic::viewer {

struct App;
struct Oracle;  // the reference of the model that is shown

struct MapChoice {
    std::optional<MapKind> kind;  // none: the picture
    bool is_split = false;
    double divider = 0.5;             // of the view's width
    int second = solver_default + 1;  // draws the right half, and the other picture of differences
};

// A map of the whole view, of which a split view shows one half.
struct ShownMap {
    Legend legend;
    std::vector<std::uint8_t> rgba;
    GlTexture texture;
};

// Maps are made once the camera rests, errors on a thread of their own. What was made from another
// view, or by other solvers, is never shown.
struct MapView {
    explicit MapView(std::function<void()> wake) : worker(std::move(wake)) {}

    MapChoice choice;
    std::uint64_t wanted = 1;  // rises with whatever changes the map
    std::uint64_t begun = 0;   // what of it was begun with
    std::uint64_t shown = 0;   // what of it the maps below show
    PixelSize size;
    std::vector<ShownMap> maps;  // two if the view is split
    std::shared_ptr<Oracle> oracle;
    Worker<std::vector<Map>> worker;
};

bool is_split(const App& app);
bool is_map_shown(const App& app);
bool is_map_awaited(const App& app);
// Whether it can go on at once: nothing moves, and no thread is at it.
bool is_map_preparing(const App& app);

// Begins the map if nothing moves any more, and takes over what is finished; tells whether a new
// map is shown.
bool advance_map(App& app);
// What is in the view, RGBA, rows from the bottom up.
std::vector<std::uint8_t> seen_pixels(const App& app);

}  // namespace quartic::viewer
