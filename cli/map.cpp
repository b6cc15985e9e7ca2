// Turns what was drawn into maps and into pictures of two halves.
#include "cli/arguments.h"
#include "cli/legend.h"
#include "cli/render.h"
#include "cli/signals.h"
#include "diagnostics/check.h"
#include "solvers/solver_table.h"

namespace quartic::cli {
namespace {

// What draws the picture, or its left half.
std::string first_name(const RenderArguments& arguments) {
    if (!arguments.solvers.everywhere.empty()) {
        return arguments.solvers.everywhere;
    }
    return arguments.solvers.by_materials.empty() ? "convexity_split" : "the materials' solvers";
}

class MapMaker {
public:
    MapMaker(const Scene& scene, const View& view, const RenderArguments& arguments)
        : scene_(scene), view_(view), arguments_(arguments) {}

    Map map_of(MapKind kind, const GBuffer& picture, int solver) const {
        switch (kind) {
            case MapKind::steps: return count_map(kind, picture.size, picture.steps, picture.rays);
            case MapKind::rays: return count_map(kind, picture.size, picture.rays, picture.rays);
            case MapKind::error: return error_of(picture);
            case MapKind::solver: return solver_map(scene_, picture_of(picture), solver);
            case MapKind::difference: break;
        }
        check_failed("a difference is of two pictures", __FILE__, __LINE__);
    }

    Map difference(const GBuffer& first, const GBuffer& second) const {
        return difference_map(view_, {picture_of(first), first_name(arguments_)},
                              {picture_of(second), arguments_.against});
    }

private:
    Map error_of(const GBuffer& picture) const {
        const Reference reference(scene_, render_options(arguments_).layers, solver_default);
        return error_map(reference, view_, picture_of(picture), is_interrupted);
    }

    const Scene& scene_;
    const View& view_;
    const RenderArguments& arguments_;
};

}  // namespace

void show_map(const Scene& scene, const View& view, const RenderArguments& arguments,
              const Drawn* second, Drawn& drawn) {
    const MapKind kind = find_map(arguments.map).value_or(MapKind::steps);
    const MapMaker maker(scene, view, arguments);
    Map map = kind == MapKind::difference
                  ? maker.difference(drawn.picture, second->picture)
                  : maker.map_of(kind, drawn.picture, solver_number(arguments.solvers.everywhere));
    if (!arguments.split.empty()) {
        const Map right = maker.map_of(kind, second->picture, solver_number(arguments.split));
        map = split_maps(map, right, divider_of(map.size));
    }
    const MapScale scale = scale_of(map);
    drawn.colours = colours_of(map, scale);
    if (!arguments.split.empty()) {
        draw_divider(drawn.colours, map.size, first_name(arguments), arguments.split);
    }
    draw_legend(drawn.colours, map.size, legend_of(map, scale));
    drawn.map = std::move(map);
}

void show_halves(const RenderArguments& arguments, const Drawn& second, Drawn& drawn) {
    const PixelSize size = drawn.picture.size;
    for (int y = 0; y < size.height; ++y) {
        const auto from = static_cast<std::ptrdiff_t>(4 * pixel_index(size, divider_of(size), y));
        const auto end = static_cast<std::ptrdiff_t>(4 * pixel_index(size, 0, y + 1));
        std::copy(second.colours.begin() + from, second.colours.begin() + end,
                  drawn.colours.begin() + from);
    }
    draw_divider(drawn.colours, size, first_name(arguments), arguments.split);
}

}  // namespace quartic::cli
