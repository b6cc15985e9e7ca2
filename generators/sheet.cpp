// Every primitive with every awkward parameter, each its own node, on a grid a metre apart.
#include "generators/kinds.h"

#include "scene/add_shape.h"

#include <array>
#include <cmath>
#include <numbers>

namespace quartic {
namespace {

constexpr double degree = std::numbers::pi / 180.0;
constexpr double full_turn = 2.0 * std::numbers::pi;
constexpr int columns = 12;

// Places shapes one after the other, turned by another angle each.
class Sheet {
public:
    Sheet() {
        scene_.materials.push_back({"sheet", {0.46f, 0.49f, 0.52f, 1.0f}, 0});
        for (const ShapeRow& row : shape_table()) {
            scene_.kinds.emplace_back(row.name);
        }
        Node root;
        root.name = scene_.strings.add("SHEET");
        scene_.nodes.push_back(root);
    }

    template <class Shape>
    void add(std::string_view label, const Shape& shape) {
        const int number = static_cast<int>(scene_.nodes.size()) - 1;
        Node node;
        node.name = scene_.strings.add(label);
        node.parent = 0;
        node.position = {double(number % columns), double(number / columns), 0.0};
        Part part;
        part.node = static_cast<std::uint32_t>(scene_.nodes.size());
        part.kind = static_cast<std::uint8_t>(static_cast<int>(type_of<Shape>) - 1);
        part.placement.position = node.position;
        const glm::dvec3 axis =
            glm::normalize(glm::dvec3(1.0, 0.3 * (number % 5), 0.2 * (number % 7)));
        part.placement.rotation = glm::angleAxis(0.37 * number, axis);
        scene_.nodes.push_back(node);
        CHECK(add_shape(scene_, shape, part).drawn);
    }

    Scene take() { return std::move(scene_); }

private:
    Scene scene_;
};

void add_round(Sheet& sheet) {
    sheet.add("sphere", f64::Sphere{0.3, 0, 0, 0});
    sheet.add("cylinder", f64::Cylinder{0.2, 0.6, 0, 0});
    sheet.add("cylinder thin", f64::Cylinder{0.004, 0.8, 0, 0});
    sheet.add("cylinder flat", f64::Cylinder{0.35, 0.005, 0, 0});
    sheet.add("cylinder of zero height", f64::Cylinder{0.3, 0.0, 0, 0});
    sheet.add("cone", f64::Cone{0.3, 0.15, 0.5, 0});
    sheet.add("cone widening", f64::Cone{0.1, 0.3, 0.5, 0});
    sheet.add("cone with a tip", f64::Cone{0.3, 0.0, 0.5, 0});
    sheet.add("cone with a tip below", f64::Cone{0.0, 0.3, 0.5, 0});
    sheet.add("cone of equal radii", f64::Cone{0.2, 0.2, 0.5, 0});
    sheet.add("cone of almost equal radii", f64::Cone{0.2, 0.2000001, 0.5, 0});
    sheet.add("cone of zero height", f64::Cone{0.3, 0.2, 0.0, 0});
    sheet.add("dish elliptical", f64::Dish{0.3, 0.15, 0, 0});
    sheet.add("dish elliptical high", f64::Dish{0.2, 0.4, 0, 0});
    sheet.add("dish elliptical flat", f64::Dish{0.35, 0.01, 0, 0});
    sheet.add("dish of zero height", f64::Dish{0.3, 0.0, 0, 0});
    sheet.add("dish spherical", f64::Dish{0.3, 0.1, 1, 0});
    sheet.add("dish hemisphere", f64::Dish{0.3, 0.3, 1, 0});
    sheet.add("dish of more than a hemisphere", f64::Dish{0.2, 0.5, 1, 0});
    sheet.add("disk", f64::Disk{0.3, 0, 0, 0});
    sheet.add("annulus", f64::Disk{0.3, 0.2, 0, 0});
    sheet.add("annulus narrow", f64::Disk{0.3, 0.298, 0, 0});
}

void add_snouts(Sheet& sheet) {
    sheet.add("snout eccentric", f64::Snout{0.3, 0.2, 0.5, 0.1, 0, 0, 0, 0});
    sheet.add("snout leaning", f64::Snout{0.25, 0.15, 0.4, 0.3, 0, 0, 0, 0});
    sheet.add("snout oblique cylinder", f64::Snout{0.2, 0.2, 0.5, 0.2, 0, 0, 0, 0});
    sheet.add("snout with a leaning tip", f64::Snout{0.3, 0.0, 0.5, 0.2, 0, 0, 0, 0});
    sheet.add("snout with a leaning tip below", f64::Snout{0.0, 0.3, 0.5, 0.2, 0, 0, 0, 0});
    sheet.add("snout sheared below", f64::Snout{0.2, 0.2, 0.6, 0, 0.4, 0, 0, 0});
    sheet.add("snout sheared above", f64::Snout{0.2, 0.2, 0.6, 0, 0, 0, -0.3, 0.3});
    sheet.add("snout mitred", f64::Snout{0.15, 0.15, 0.7, 0, 1.0, 0, -1.0, 0});
    sheet.add("snout gore", f64::Snout{0.3, 0.3, 0.3, 0, 0.5, 0, -0.5, 0});
    sheet.add("snout sheared cone", f64::Snout{0.3, 0.15, 0.5, 0, 0.3, 0.2, 0.2, -0.3});
    sheet.add("snout eccentric and sheared", f64::Snout{0.3, 0.15, 0.5, 0.1, 0.3, -0.2, 0.2, 0.3});
    sheet.add("snout of equal radii", f64::Snout{0.2, 0.2, 0.5, 0, 0, 0, 0, 0});
    sheet.add("snout of zero height", f64::Snout{0.3, 0.2, 0.0, 0.05, 0, 0, 0, 0});
}

std::string text(double value) {
    const auto tenths = static_cast<long>(std::lround(10.0 * value));
    return std::to_string(tenths / 10) +
           (tenths % 10 == 0 ? "" : "." + std::to_string(tenths % 10));
}

void add_tori(Sheet& sheet) {
    for (const double arc_deg :
         {5.0, 15.0, 30.0, 45.0, 60.0, 90.0, 120.0, 180.0, 200.0, 270.0, 315.0, 355.0, 360.0}) {
        const double arc = arc_deg == 360.0 ? full_turn : arc_deg * degree;
        sheet.add("torus arc " + text(arc_deg), f64::Torus{0.28, 0.1, arc, 0});
    }
    for (const double ratio : {1.0, 1.1, 1.5, 2.0, 5.0, 20.0, 62.0, 150.0, 400.0}) {
        const double radius = 0.4 / (1.0 + ratio);
        sheet.add("torus R/r " + text(ratio), f64::Torus{ratio * radius, radius, full_turn, 0});
        sheet.add("torus R/r " + text(ratio) + " elbow",
                  f64::Torus{ratio * radius, radius, 90.0 * degree, 0});
    }
    for (const double arc_deg : {10.0, 45.0, 90.0, 180.0, 225.0, 300.0, 360.0}) {
        const double arc = arc_deg == 360.0 ? full_turn : arc_deg * degree;
        sheet.add("rectangular torus arc " + text(arc_deg),
                  f64::RectangularTorus{0.2, 0.4, 0.15, arc});
    }
    sheet.add("rectangular torus without bore",
              f64::RectangularTorus{0.0, 0.4, 0.15, 120.0 * degree});
    sheet.add("rectangular torus of zero height",
              f64::RectangularTorus{0.2, 0.4, 0.0, 120.0 * degree});
}

void add_flat(Sheet& sheet) {
    sheet.add("box", f64::Box{0.3, 0.4, 0.5, 0});
    sheet.add("box thin", f64::Box{0.002, 0.4, 0.6, 0});
    sheet.add("box of zero thickness", f64::Box{0.5, 0.4, 0.0, 0});
    sheet.add("pyramid", f64::Pyramid{0.5, 0.4, 0.2, 0.15, 0, 0, 0.4, 0});
    sheet.add("pyramid leaning", f64::Pyramid{0.4, 0.4, 0.2, 0.2, 0.2, -0.1, 0.4, 0});
    sheet.add("pyramid with a tip", f64::Pyramid{0.5, 0.5, 0.0, 0.0, 0, 0, 0.5, 0});
    sheet.add("pyramid wedge", f64::Pyramid{0.5, 0.4, 0.0, 0.4, 0, 0, 0.4, 0});
    sheet.add("pyramid with crossed edges", f64::Pyramid{0.5, 0.0, 0.0, 0.5, 0, 0, 0.4, 0});
    sheet.add("pyramid of zero height", f64::Pyramid{0.5, 0.4, 0.2, 0.2, 0.1, 0, 0.0, 0});
    sheet.add("pyramid plate", f64::Pyramid{0.0, 0.5, 0.0, 0.2, 0, 0, 0.4, 0});
}

}  // namespace

Scene make_sheet(const GenerateOptions&) {
    Sheet sheet;
    add_round(sheet);
    add_snouts(sheet);
    add_tori(sheet);
    add_flat(sheet);
    return sheet.take();
}

}  // namespace quartic
