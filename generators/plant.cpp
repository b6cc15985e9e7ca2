// A plant: units in rows, rows in areas, as many as the count needs.
#include "generators/kinds.h"
#include "generators/random.h"
#include "generators/unit.h"

#include <algorithm>
#include <cmath>

namespace quartic {
namespace {

constexpr double parts_of_unit = 3000.0;  // about
constexpr double road = 4.0;

// What a row of units stands on.
void add_road(Model& model, const glm::dvec3& corner, const glm::dvec2& size) {
    const double margin = 0.5 * road;
    model.begin("ROAD", corner);
    model.use(Finish::road);
    model.box(corner + glm::dvec3(0.5 * size.x, 0.5 * unit_width, -0.25),
              {size.x + 2.0 * margin, size.y, 0.2});
    model.end();
}

}  // namespace

Scene make_plant(const GenerateOptions& options) {
    Model model(options.count);
    const auto expected =
        std::max(1.0, std::ceil(static_cast<double>(options.count) / parts_of_unit));
    const auto columns =
        static_cast<std::uint64_t>(std::ceil(std::sqrt(expected * unit_width / unit_length)));
    const double pitch_x =
        options.extent_m > 0.0 ? options.extent_m / double(columns) : unit_length;
    const double pitch_y =
        options.extent_m > 0.0 ? options.extent_m / double(columns) : unit_width + road;
    const bool joined = pitch_x == unit_length;
    model.begin("SITE-1", glm::dvec3(0.0));
    for (std::uint64_t row = 0; !model.is_full(); ++row) {
        const glm::dvec3 corner(0.0, pitch_y * double(row), 0.0);
        model.begin("AREA-" + std::to_string(row + 1), corner);
        add_road(model, corner, {pitch_x * double(columns), pitch_y});
        const std::uint64_t row_seed = Random(options.seed, 2 * row + 1).next();
        for (std::uint64_t column = 0; column < columns && !model.is_full(); ++column) {
            UnitPlace place;
            place.corner = corner + glm::dvec3(pitch_x * double(column), 0.0, 0.0);
            place.row_seed = joined ? row_seed : Random(row_seed, column).next();
            place.unit_seed = Random(options.seed, 2 * (row * columns + column) + 2).next();
            place.first = column == 0 || !joined;
            place.last = column + 1 == columns || !joined;
            place.number = static_cast<int>(row * columns + column + 1);
            add_unit(model, place);
        }
        model.end();
    }
    model.end();
    return model.take();
}

}  // namespace quartic
