// Maps: a picture's pixels as numbers and kinds that show what the solvers did there.
#pragma once

#include "scene/colour_map.h"
#include "scene/compare.h"

#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace quartic {

enum class MapKind : std::uint8_t { steps, rays, error, solver, difference };

struct MapRow {
    MapKind kind;
    std::string_view name;  // as scripts know it
    std::string_view title;
    std::string_view unit;
};

std::span<const MapRow> map_table();
const MapRow& row_of(MapKind kind);
std::optional<MapKind> find_map(std::string_view name);

// Pixels that no number describes.
struct MapClass {
    std::string name;  // as scripts know it: "wrong_part", a solver's name
    std::string text;
    Rgb colour;
    std::uint64_t count = 0;
};

struct Map {
    MapKind kind = MapKind::steps;
    PixelSize size;
    std::vector<float> values;          // rows from the bottom up; not a number: none
    std::vector<std::uint8_t> classes;  // 0: none; else one more than the index in the list below
    std::vector<MapClass> class_list;
};

// Steps or rays of a frame that was inspected; nothing where no ray was solved.
Map count_map(MapKind kind, PixelSize size, std::span<const std::uint16_t> counts,
              std::span<const std::uint16_t> rays);

// Metres along the ray between what the picture shows and what the reference hits. Classes: missed,
// false, wrong_part, and tie: one of those, but another ray within 0.01 pixels agrees. A map that
// was stopped holds only some of its rows.
Map error_map(const Reference& reference, const View& view, const Picture& picture,
              const std::function<bool()>& stop = {});

// The solver of the part that is seen, as solver_of() says.
Map solver_map(const Scene& scene, const Picture& picture, int everywhere,
               std::span<const int> of_materials = {});

// Metres along the ray between two pictures of one view. Classes: only_first, only_second,
// other_part.
struct NamedPicture {
    Picture picture;
    std::string name;
};
Map difference_map(const View& view, const NamedPicture& first, const NamedPicture& second);

// Columns below divider_px from the first map, the others from the second; maps of one kind and
// size.
Map split_maps(const Map& first, const Map& second, int divider_px);

}  // namespace quartic
