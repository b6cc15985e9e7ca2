// Makes maps, pixel by pixel.
#include "scene/map.h"

#include "diagnostics/check.h"
#include "scene/rows.h"
#include "solvers/solver_table.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace quartic {
namespace {

constexpr float no_value = std::numeric_limits<float>::quiet_NaN();
constexpr Rgb red{230, 25, 30};
constexpr Rgb magenta{255, 0, 220};
constexpr Rgb orange{255, 140, 0};
constexpr Rgb grey{130, 130, 130};

constexpr MapRow rows[] = {
    {MapKind::steps, "steps", "Solver steps per pixel, all rays", "steps"},
    {MapKind::rays, "rays", "Rays solved per pixel", "rays"},
    {MapKind::error, "error", "Position error", "m"},
    {MapKind::solver, "solver", "Solver of the visible part", ""},
    {MapKind::difference, "difference", "Position difference", "m"},
};

Map empty_map(MapKind kind, PixelSize size) {
    const std::size_t count = pixel_count(size);
    Map map;
    map.kind = kind;
    map.size = size;
    map.values.assign(count, no_value);
    map.classes.assign(count, 0);
    return map;
}

void count_classes(Map& map) {
    for (MapClass& one : map.class_list) {
        one.count = 0;
    }
    for (const std::uint8_t number : map.classes) {
        if (number != 0) {
            map.class_list[number - 1u].count += 1;
        }
    }
}

// How many metres along a pixel's ray one metre of view depth is.
double metres_per_depth(const View& view, int x, int y) {
    return glm::length(pixel_ray(view, x + 0.5, y + 0.5).direction);
}

std::uint8_t class_of(const Judged& judged) {
    constexpr std::uint8_t tie = 4;
    switch (judged.verdict) {
        case Verdict::nothing:
        case Verdict::agrees: return 0;
        case Verdict::missed: return judged.is_tie ? tie : 1;
        case Verdict::false_hit: return judged.is_tie ? tie : 2;
        case Verdict::wrong_part: return judged.is_tie ? tie : 3;
    }
    return 0;
}

// Calls work(x, y, index of the pixel) for all pixels, row by row.
template <class Work>
void for_each_pixel(PixelSize size, const Work& work) {
    std::size_t at = 0;
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            work(x, y, at++);
        }
    }
}

}  // namespace

std::span<const MapRow> map_table() {
    return rows;
}

const MapRow& row_of(MapKind kind) {
    return rows[static_cast<std::size_t>(kind)];
}

std::optional<MapKind> find_map(std::string_view name) {
    for (const MapRow& row : rows) {
        if (row.name == name) {
            return row.kind;
        }
    }
    return {};
}

Map count_map(MapKind kind, PixelSize size, std::span<const std::uint16_t> counts,
              std::span<const std::uint16_t> rays) {
    Map map = empty_map(kind, size);
    CHECK(counts.size() == map.values.size() && rays.size() == map.values.size());
    for (std::size_t i = 0; i < counts.size(); ++i) {
        map.values[i] = rays[i] > 0 ? static_cast<float>(counts[i]) : no_value;
    }
    return map;
}

Map error_map(const Reference& reference, const View& view, const Picture& picture,
              const std::function<bool()>& stop) {
    Map map = empty_map(MapKind::error, picture.size);
    map.class_list = {{"missed", "missed", red},
                      {"false", "false hit", magenta},
                      {"wrong_part", "wrong part", orange},
                      {"tie", "at an edge, within 0.01 px", grey}};
    const auto judge_row = [&](int y) {
        for (int x = 0; x < picture.size.width; ++x) {
            const std::size_t at = pixel_index(picture.size, x, y);
            const Judged judged = judge(reference, view, picture, x, y);
            map.classes[at] = class_of(judged);
            if (judged.verdict == Verdict::agrees) {
                const double apart =
                    std::abs(static_cast<double>(picture.depth_m[at]) - judged.truth.t);
                map.values[at] = static_cast<float>(apart * metres_per_depth(view, x, y));
            }
        }
    };
    for_each_row(picture.size.height, judge_row, stop);
    count_classes(map);
    return map;
}

Map solver_map(const Scene& scene, const Picture& picture, int everywhere,
               std::span<const int> of_materials) {
    Map map = empty_map(MapKind::solver, picture.size);
    for (std::size_t i = 0; i < solver_table().size(); ++i) {
        const std::string name(solver_table()[i].name);
        map.class_list.push_back({name, name, kind_colour(i)});
    }
    map.class_list.push_back({"closed_form", "no choice: in closed form", grey});
    for (std::size_t i = 0; i < picture.ids.size(); ++i) {
        if (picture.ids[i] == no_index) {
            continue;
        }
        const Part& part = scene.parts[picture.ids[i]];
        const int id = solver_of(scene, part, everywhere, of_materials);
        const auto found = std::find_if(
            solver_table().begin(), solver_table().end(),
            [&](const SolverRow& row) { return row.id == id && has_solvers(name(part.type)); });
        map.classes[i] = static_cast<std::uint8_t>(found - solver_table().begin() + 1);
    }
    count_classes(map);
    return map;
}

Map difference_map(const View& view, const NamedPicture& first, const NamedPicture& second) {
    CHECK(first.picture.ids.size() == second.picture.ids.size());
    Map map = empty_map(MapKind::difference, first.picture.size);
    map.class_list = {{"only_first", "only " + first.name, red},
                      {"only_second", "only " + second.name, magenta},
                      {"other_part", "other parts", orange}};
    for_each_pixel(map.size, [&](int x, int y, std::size_t at) {
        const std::uint32_t one = first.picture.ids[at];
        const std::uint32_t other = second.picture.ids[at];
        if (one == no_index && other == no_index) {
            return;
        }
        if (one != other) {
            map.classes[at] = other == no_index ? 1 : one == no_index ? 2 : 3;
            return;
        }
        const double apart = std::abs(static_cast<double>(first.picture.depth_m[at]) -
                                      static_cast<double>(second.picture.depth_m[at]));
        map.values[at] = static_cast<float>(apart * metres_per_depth(view, x, y));
    });
    count_classes(map);
    return map;
}

Map split_maps(const Map& first, const Map& second, int divider_px) {
    CHECK(first.size == second.size && first.class_list.size() == second.class_list.size());
    Map map = first;
    for_each_pixel(map.size, [&](int x, int, std::size_t at) {
        if (x >= divider_px) {
            map.values[at] = second.values[at];
            map.classes[at] = second.classes[at];
        }
    });
    count_classes(map);
    return map;
}

}  // namespace quartic
