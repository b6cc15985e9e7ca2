// Frames from end points, in double, so that what is joined meets exactly.
#include "generators/model.h"

#include "scene/add_shape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace quartic {
namespace {

struct FinishRow {
    const char* name;
    glm::vec4 colour;  // linear
};

// In the order of Finish.
constexpr FinishRow finishes[] = {
    {"process", {0.46f, 0.49f, 0.52f, 1.0f}},     {"steam", {0.55f, 0.19f, 0.07f, 1.0f}},
    {"water", {0.05f, 0.30f, 0.13f, 1.0f}},       {"gas", {0.70f, 0.44f, 0.05f, 1.0f}},
    {"fire water", {0.55f, 0.03f, 0.02f, 1.0f}},  {"air", {0.13f, 0.36f, 0.62f, 1.0f}},
    {"chemical", {0.20f, 0.09f, 0.25f, 1.0f}},    {"steel", {0.07f, 0.13f, 0.19f, 1.0f}},
    {"grating", {0.19f, 0.20f, 0.21f, 1.0f}},     {"rail", {0.78f, 0.50f, 0.02f, 1.0f}},
    {"concrete", {0.42f, 0.40f, 0.37f, 1.0f}},    {"ground", {0.27f, 0.26f, 0.24f, 1.0f}},
    {"road", {0.09f, 0.09f, 0.10f, 1.0f}},        {"vessel", {0.60f, 0.62f, 0.63f, 1.0f}},
    {"machine", {0.04f, 0.19f, 0.33f, 1.0f}},     {"wheel", {0.45f, 0.02f, 0.02f, 1.0f}},
    {"duct", {0.52f, 0.55f, 0.57f, 1.0f}},        {"tray", {0.33f, 0.35f, 0.36f, 1.0f}},
    {"insulation", {0.70f, 0.75f, 0.80f, 0.35f}},
};

constexpr std::array<const char*, shape_type_count> kind_names = {
    "mesh",
#define SHAPE(id, Type, name) #name,
#include "primitives/catalog.h"
#undef SHAPE
};

}  // namespace

glm::dmat3 axes_along(const glm::dvec3& z, const glm::dvec3& x_hint) {
    const glm::dvec3 x = glm::normalize(x_hint - glm::dot(x_hint, z) * z);
    return {x, glm::cross(z, x), z};
}

glm::dmat3 axes_along(const glm::dvec3& z) {
    return axes_along(z,
                      std::abs(z.x) < 0.9 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 0.0, 1.0));
}

Model::Model(std::uint64_t count_wanted) : count_wanted_(count_wanted) {
    for (const FinishRow& row : finishes) {
        scene_.materials.push_back({row.name, row.colour, 0});
    }
    for (const char* name : kind_names) {
        scene_.kinds.emplace_back(name);
    }
}

void Model::begin(std::string_view name, const glm::dvec3& position) {
    Node node;
    node.name = scene_.strings.add(name);
    node.parent = open_.empty() ? no_index : open_.back();
    node.position = position;
    node.first_attribute = static_cast<std::uint32_t>(scene_.attributes.size());
    here_ = position;
    open_.push_back(static_cast<std::uint32_t>(scene_.nodes.size()));
    scene_.nodes.push_back(node);
}

void Model::end() {
    open_.pop_back();
    if (!open_.empty()) {
        here_ = scene_.nodes[open_.back()].position;
    }
}

// Only right after begin(): a node's attributes stand together.
void Model::attribute(std::string_view key, std::string_view value) {
    Node& node = scene_.nodes[open_.back()];
    CHECK(node.first_attribute + node.attribute_count == scene_.attributes.size());
    scene_.attributes.push_back({scene_.strings.add(key), scene_.strings.add(value)});
    ++node.attribute_count;
}

template <class Shape>
void Model::add(const Shape& shape, const glm::dvec3& position, const glm::dmat3& axes) {
    CHECK(!open_.empty());
    Part part;
    part.placement.position = position;
    part.placement.rotation = glm::normalize(glm::quat_cast(axes));
    part.node = open_.back();
    part.material = static_cast<std::uint32_t>(finish_);
    part.layer = layer_;
    part.kind = static_cast<std::uint8_t>(type_of<Shape>);
    CHECK(add_shape(scene_, shape, part).drawn);
}

void Model::cylinder(const glm::dvec3& from, const glm::dvec3& to, double radius) {
    const double length = glm::length(to - from);
    add(f64::Cylinder{radius, length, 0.0, 0.0}, 0.5 * (from + to),
        axes_along((to - from) / length));
}

void Model::cone(const Circle& from, const Circle& to) {
    const glm::dvec3 along = to.centre - from.centre;
    const double length = glm::length(along);
    add(f64::Cone{from.radius, to.radius, length, 0.0}, 0.5 * (from.centre + to.centre),
        axes_along(along / length));
}

void Model::reducer(const Circle& from, const Circle& to, const glm::dvec3& axis) {
    const glm::dvec3 along = to.centre - from.centre;
    const double height = glm::dot(along, axis);
    const glm::dvec3 aside = along - height * axis;
    const double offset = glm::length(aside);
    if (offset < 1e-9) {
        cone(from, to);
        return;
    }
    add(f64::Snout{from.radius, to.radius, height, offset, 0.0, 0.0, 0.0, 0.0},
        0.5 * (from.centre + to.centre), axes_along(axis, aside));
}

void Model::mitred(const Circle& from, const glm::dvec3& to, const glm::dvec3& from_normal,
                   const glm::dvec3& to_normal) {
    const double length = glm::length(to - from.centre);
    const glm::dmat3 axes = axes_along((to - from.centre) / length);
    // A plane with normal n rises by -n.x / n.z along x.
    const glm::dvec3 bottom = glm::transpose(axes) * from_normal;
    const glm::dvec3 top = glm::transpose(axes) * to_normal;
    add(f64::Snout{from.radius, from.radius, length, 0.0, -bottom.x / bottom.z,
                   -bottom.y / bottom.z, -top.x / top.z, -top.y / top.z},
        0.5 * (from.centre + to), axes);
}

void Model::torus(const Turn& turn, double bend_radius, double radius) {
    add(f64::Torus{bend_radius, radius, turn.arc, 0.0}, turn.centre,
        axes_along(turn.axis, turn.from));
}

void Model::duct_turn(const Turn& turn, const glm::dvec2& radii, double height) {
    add(f64::RectangularTorus{radii.x, radii.y, height, turn.arc}, turn.centre,
        axes_along(turn.axis, turn.from));
}

void Model::dish(const Circle& base, const glm::dvec3& out, double height, bool spherical) {
    add(f64::Dish{base.radius, height, spherical ? 1.0 : 0.0, 0.0}, base.centre, axes_along(out));
}

void Model::sphere(const Circle& ball) {
    add(f64::Sphere{ball.radius, 0.0, 0.0, 0.0}, ball.centre, glm::dmat3(1.0));
}

// As plants have them: a cylinder without height.
void Model::disc(const Circle& circle, const glm::dvec3& normal) {
    add(f64::Cylinder{circle.radius, 0.0, 0.0, 0.0}, circle.centre, axes_along(normal));
}

void Model::box(const glm::dvec3& centre, const glm::dvec3& lengths) {
    add(f64::Box{lengths.x, lengths.y, lengths.z, 0.0}, centre, glm::dmat3(1.0));
}

void Model::bar(const glm::dvec3& from, const glm::dvec3& to, double width, double height) {
    const double length = glm::length(to - from);
    const glm::dvec3 along = (to - from) / length;
    const glm::dvec3 up =
        std::abs(along.z) > 0.99 ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(0.0, 0.0, 1.0);
    const glm::dvec3 across = glm::normalize(glm::cross(up, along));
    const glm::dmat3 axes(along, across, glm::cross(along, across));
    add(f64::Box{length, width, height, 0.0}, 0.5 * (from + to), axes);
}

void Model::pyramid(const f64::Pyramid& shape, const glm::dvec3& centre) {
    add(shape, centre, glm::dmat3(1.0));
}

// The last item may have gone beyond the count; every part has a shape of its own, the last of its
// array.
void Model::drop_excess() {
    const std::uint64_t most = count_wanted_ + count_wanted_ / 20;
    while (scene_.parts.size() > most) {
        switch (scene_.parts.back().type) {
#define SHAPE(id, Type, name)          \
    case ShapeType::name:              \
        scene_.shapes.name.pop_back(); \
        break;
#include "primitives/catalog.h"
#undef SHAPE
            case ShapeType::mesh: break;
        }
        scene_.parts.pop_back();
    }
}

Scene Model::take() {
    drop_excess();
    scene_.kind_counts.assign(scene_.kinds.size(), 0);
    for (const Part& part : scene_.parts) {
        ++scene_.kind_counts[part.kind];
    }
    for (std::size_t i = 0; i < scene_.kinds.size(); ++i) {
        if (scene_.kind_counts[i] > 0) {
            scene_.outcomes.push_back({scene_.kinds[i], "analytic", "", scene_.kind_counts[i]});
        }
    }
    return std::move(scene_);
}

}  // namespace quartic
