// Parts as lines of text, one function for each shape.
#include "scene/describe.h"

#include "diagnostics/check.h"

#include <charconv>
#include <cmath>
#include <numbers>

namespace quartic {
namespace {

using Properties = std::vector<Property>;

std::string number_text(double value, int digits) {
    char text[512];  // enough for 1e308 written out
    const std::to_chars_result end =
        std::to_chars(text, text + sizeof(text), value, std::chars_format::fixed, digits);
    std::string number(text, end.ptr);
    if (number.find('.') != std::string::npos) {
        number.erase(number.find_last_not_of('0') + 1);
        if (number.back() == '.') {
            number.pop_back();
        }
    }
    return number == "-0" ? "0" : number;
}

void add_length(Properties& list, std::string label, double metres) {
    list.push_back({std::move(label), length_text(metres)});
}

void add_diameter(Properties& list, std::string label, double radius) {
    add_length(list, std::move(label), 2.0 * radius);
}

void add_angle(Properties& list, std::string label, double radians) {
    list.push_back({std::move(label), angle_text(radians)});
}

void add_size(Properties& list, std::string label, double x, double y) {
    list.push_back({std::move(label), length_text(x) + " x " + length_text(y)});
}

Properties describe_one(const f64::Sphere& sphere) {
    Properties list;
    add_diameter(list, "Diameter", sphere.radius);
    return list;
}

Properties describe_one(const f64::Dish& dish) {
    Properties list{{"Form", f64().is_spherical(dish) ? "spherical" : "ellipsoidal"}};
    add_diameter(list, "Diameter", dish.radius);
    add_length(list, "Dish height", dish.height);
    if (f64().is_spherical(dish)) {
        add_length(list, "Sphere radius", f64().equator_radius(dish));
    }
    return list;
}

Properties describe_one(const f64::Cylinder& cylinder) {
    Properties list;
    add_diameter(list, "Diameter", cylinder.radius);
    add_length(list, "Length", cylinder.height);
    return list;
}

Properties describe_one(const f64::Cone& cone) {
    Properties list;
    add_diameter(list, "Bottom diameter", cone.bottom_radius);
    add_diameter(list, "Top diameter", cone.top_radius);
    add_length(list, "Length", cone.height);
    return list;
}

void add_cut(Properties& list, std::string label, double slope_x, double slope_y) {
    if (slope_x != 0.0 || slope_y != 0.0) {
        add_angle(list, std::move(label), std::atan(std::hypot(slope_x, slope_y)));
    }
}

Properties describe_one(const f64::Snout& snout) {
    Properties list;
    add_diameter(list, "Bottom diameter", snout.bottom_radius);
    add_diameter(list, "Top diameter", snout.top_radius);
    add_length(list, "Length", snout.height);
    add_length(list, "Offset", snout.offset);
    add_cut(list, "Bottom cut", snout.bottom_slope_x, snout.bottom_slope_y);
    add_cut(list, "Top cut", snout.top_slope_x, snout.top_slope_y);
    return list;
}

Properties describe_one(const f64::Torus& torus) {
    Properties list;
    add_diameter(list, "Diameter", torus.radius);
    add_length(list, "Bend radius", torus.bend_radius);
    list.push_back({"R/D", number_text(torus.bend_radius / (2.0 * torus.radius), 3)});
    add_angle(list, "Angle", torus.arc);
    add_length(list, "Arc length", torus.bend_radius * torus.arc);
    return list;
}

Properties describe_one(const f64::RectangularTorus& torus) {
    Properties list;
    add_length(list, "Inner radius", torus.inner_radius);
    add_length(list, "Outer radius", torus.outer_radius);
    add_length(list, "Height", torus.height);
    add_angle(list, "Angle", torus.arc);
    return list;
}

Properties describe_one(const f64::Box& box) {
    Properties list;
    add_length(list, "Length x", box.length_x);
    add_length(list, "Length y", box.length_y);
    add_length(list, "Length z", box.length_z);
    return list;
}

Properties describe_one(const f64::Pyramid& pyramid) {
    Properties list;
    add_size(list, "Bottom widths", pyramid.bottom_x, pyramid.bottom_y);
    add_size(list, "Top widths", pyramid.top_x, pyramid.top_y);
    add_size(list, "Offset", pyramid.offset_x, pyramid.offset_y);
    add_length(list, "Height", pyramid.height);
    return list;
}

Properties describe_one(const f64::CubicSurface& surface) {
    Properties list;
    add_length(list, "Cube", 2.0 * surface.half_size);
    return list;
}

Properties describe_one(const f64::QuarticSurface& surface) {
    Properties list;
    add_length(list, "Cube", 2.0 * surface.half_size);
    return list;
}

Properties describe_one(const f64::Disk& disk) {
    Properties list;
    add_diameter(list, "Diameter", disk.radius);
    if (disk.inner_radius > 0.0) {
        add_diameter(list, "Inner diameter", disk.inner_radius);
    }
    return list;
}

Properties describe_mesh(const Mesh& mesh) {
    return {{"Triangles", std::to_string(mesh.indices.size() / 3)},
            {"Vertices", std::to_string(mesh.positions.size())}};
}

}  // namespace

std::string length_text(double metres) {
    return number_text(1000.0 * metres, 3) + " mm";
}

std::string angle_text(double radians) {
    return number_text(radians * 180.0 / std::numbers::pi, 3) + "\u00b0";
}

std::string position_text(const glm::dvec3& metres) {
    return number_text(1000.0 * metres.x, 1) + ", " + number_text(1000.0 * metres.y, 1) + ", " +
           number_text(1000.0 * metres.z, 1) + " mm";
}

std::string spoken(std::string_view name) {
    std::string words(name);
    for (char& c : words) {
        c = c == '_' ? ' ' : c;
    }
    return words;
}

std::string_view name(Layer layer) {
    switch (layer) {
        case Layer::normal: return "normal";
        case Layer::obstruction: return "obstruction";
        case Layer::insulation: return "insulation";
        case Layer::line: return "line";
    }
    return "unknown";
}

std::vector<Property> describe_shape(const Scene& scene, const Part& part) {
    if (part.type == ShapeType::mesh) {
        return describe_mesh(scene.meshes[part.shape]);
    }
    return visit_shape(scene.shapes, part.type, part.shape,
                       [](const auto& shape) { return describe_one(shape); });
}

std::vector<Property> describe(const Scene& scene, std::uint32_t part_index) {
    CHECK(part_index < scene.parts.size());
    const Part& part = scene.parts[part_index];
    Properties list;
    if (part.node < scene.nodes.size()) {
        list.push_back({"Path", path_of(scene, part.node)});
        list.push_back({"Name", std::string(scene.strings[scene.nodes[part.node].name])});
    }
    if (part.kind < scene.kinds.size()) {
        list.push_back({"Kind", spoken(scene.kinds[part.kind])});
    }
    list.push_back({"Shape", spoken(name(part.type))});
    const Properties shape = describe_shape(scene, part);
    list.insert(list.end(), shape.begin(), shape.end());
    if (part.material < scene.materials.size()) {
        const std::string& material = scene.materials[part.material].name;
        list.push_back({"Material", material.empty() ? "unnamed" : material});
    }
    list.push_back({"Layer", std::string(name(part.layer))});
    list.push_back({"Position", position_text(part.placement.position)});
    return list;
}

}  // namespace quartic
