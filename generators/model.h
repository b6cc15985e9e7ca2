// A scene under construction: the open node, the material in use, and shapes placed by their end
// points.
#pragma once

#include "scene/scene.h"

#include <glm/geometric.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace quartic {

// What parts are made of, or what flows in them; each is one material.
enum class Finish : std::uint8_t {
    process,
    steam,
    water,
    gas,
    fire_water,
    air,
    chemical,  // pipes by service
    steel,
    grating,
    rail,
    concrete,
    ground,
    road,  // structure
    vessel,
    machine,
    wheel,
    duct,
    tray,
    insulation
};

struct Circle {
    glm::dvec3 centre;
    double radius;
};

// A turn of a tube or duct about an axis: from `from` (a unit vector) counter-clockwise through the
// arc.
struct Turn {
    glm::dvec3 centre;
    glm::dvec3 axis;
    glm::dvec3 from;
    double arc;
};

class Model {
public:
    explicit Model(std::uint64_t count_wanted);

    // Nodes nest; names are those that plants use.
    void begin(std::string_view name, const glm::dvec3& position);
    void begin(std::string_view name) { begin(name, here_); }
    void end();
    void attribute(std::string_view key, std::string_view value);

    void use(Finish finish) { finish_ = finish; }
    Finish finish() const { return finish_; }
    void use(Layer layer) { layer_ = layer; }

    void cylinder(const glm::dvec3& from, const glm::dvec3& to, double radius);
    void cone(const Circle& from, const Circle& to);
    // Circles across the same axis, wherever their centres are: an eccentric reducer.
    void reducer(const Circle& from, const Circle& to, const glm::dvec3& axis);
    // A cylinder whose ends are cut by planes with these normals.
    void mitred(const Circle& from, const glm::dvec3& to, const glm::dvec3& from_normal,
                const glm::dvec3& to_normal);
    void torus(const Turn& turn, double bend_radius, double radius);
    void duct_turn(const Turn& turn, const glm::dvec2& radii, double height);
    void dish(const Circle& base, const glm::dvec3& out, double height, bool spherical = false);
    void sphere(const Circle& ball);
    void disc(const Circle& circle, const glm::dvec3& normal);
    void box(const glm::dvec3& centre, const glm::dvec3& lengths);
    // A bar of rectangular section along a line; its height lies in the plane of the line and z.
    void bar(const glm::dvec3& from, const glm::dvec3& to, double width, double height);
    void pyramid(const f64::Pyramid& shape, const glm::dvec3& centre);

    bool is_full() const { return scene_.parts.size() >= count_wanted_; }
    std::size_t part_count() const { return scene_.parts.size(); }
    Scene take();

private:
    template <class Shape>
    void add(const Shape& shape, const glm::dvec3& position, const glm::dmat3& axes);
    void drop_excess();

    Scene scene_;
    std::uint64_t count_wanted_;
    std::vector<std::uint32_t> open_;
    glm::dvec3 here_{0.0};
    Finish finish_ = Finish::process;
    Layer layer_ = Layer::normal;
};

// Right-handed axes with this z (a unit vector), and x as near to the hint as can be.
glm::dmat3 axes_along(const glm::dvec3& z, const glm::dvec3& x_hint);
glm::dmat3 axes_along(const glm::dvec3& z);

}  // namespace quartic
