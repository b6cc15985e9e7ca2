// POV-Ray's solids as shapes of ours, where the transformation leaves them such; else as triangles.
#include "importers/baked_mesh.h"
#include "importers/pov_scene.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace quartic {
namespace {

constexpr double rounding = 1e-9;
constexpr std::string_view stretched = "stretched or sheared into what is no shape of ours";
constexpr double sagitta_part = 1e-3;  // of a stretched shape's size

glm::dvec3 vector_at(const std::vector<double>& numbers, std::size_t at) {
    return {numbers[at], numbers[at + 1], numbers[at + 2]};
}

glm::dvec3 mapped(const glm::dmat4& map, const glm::dvec3& point) {
    return glm::dvec3(map * glm::dvec4(point, 1.0));
}

bool are_across(const glm::dvec3& a, const glm::dvec3& b) {
    return std::abs(glm::dot(a, b)) <= rounding * glm::length(a) * glm::length(b);
}

bool are_as_long(const glm::dvec3& a, const glm::dvec3& b) {
    return std::abs(glm::length(a) - glm::length(b)) <= rounding * glm::length(a);
}

// What a map makes of a direction and of the circles around it.
struct Circles {
    glm::dvec3 axis;     // unit
    double along = 1.0;  // factors
    double across = 1.0;
    bool sound = false;  // circles stay circles, across the axis
};

Circles circles_of(const glm::dmat4& map, const glm::dvec3& direction) {
    const glm::dmat3 linear(map);
    const glm::dvec3 unit = glm::normalize(direction);
    const glm::dvec3 side = f64().across(unit);
    const glm::dvec3 a = linear * side;
    const glm::dvec3 b = linear * glm::cross(unit, side);
    const glm::dvec3 c = linear * unit;
    Circles circles;
    circles.axis = glm::normalize(c);
    circles.along = glm::length(c);
    circles.across = glm::length(a);
    circles.sound = are_across(a, b) && are_across(a, c) && are_across(b, c) && are_as_long(a, b);
    return circles;
}

glm::dquat rotation_to(const glm::dvec3& z) {
    const glm::dvec3 x = f64().across(z);
    return glm::normalize(glm::quat_cast(glm::dmat3(x, glm::cross(z, x), z)));
}

constexpr Added refused{false, stretched};

}  // namespace

Added PovSceneBuilder::place_sphere(const PovObject& object, const glm::dmat4& map, Part& part) {
    const Circles circles = circles_of(map, {0.0, 0.0, 1.0});
    if (!circles.sound || std::abs(circles.along - circles.across) > rounding * circles.along) {
        return refused;
    }
    part.placement.position = mapped(map, vector_at(object.numbers, 0));
    return add_shape(scene_,
                     f64::Sphere{std::abs(object.numbers[3]) * circles.along, 0.0, 0.0, 0.0}, part);
}

Added PovSceneBuilder::place_box(const PovObject& object, const glm::dmat4& map, Part& part) {
    const glm::dmat3 linear(map);
    if (!are_across(linear[0], linear[1]) || !are_across(linear[0], linear[2]) ||
        !are_across(linear[1], linear[2])) {
        return refused;
    }
    const glm::dvec3 a = vector_at(object.numbers, 0);
    const glm::dvec3 b = vector_at(object.numbers, 3);
    part.placement.position = mapped(map, 0.5 * (a + b));
    part.placement.rotation = glm::normalize(glm::quat_cast(orthonormal(linear)));
    const glm::dvec3 lengths =
        glm::abs(b - a) *
        glm::dvec3(glm::length(linear[0]), glm::length(linear[1]), glm::length(linear[2]));
    return add_shape(scene_, f64::Box{lengths.x, lengths.y, lengths.z, 0.0}, part);
}

// Cylinders, cones and discs.
Added PovSceneBuilder::place_round(const PovObject& object, const glm::dmat4& map, Part& part) {
    const std::vector<double>& n = object.numbers;
    const bool cone = object.kind == PovKind::cone;
    const bool disc = object.kind == PovKind::disc;
    const glm::dvec3 from = vector_at(n, 0);
    const glm::dvec3 to = disc ? from + vector_at(n, 3) : vector_at(n, cone ? 4 : 3);
    if (!(glm::length(to - from) > 0.0)) {
        return {false, "a height of zero: nothing to see"};
    }
    const Circles circles = circles_of(map, to - from);
    if (!circles.sound) {
        return refused;
    }
    part.placement.rotation = rotation_to(circles.axis);
    part.placement.position = mapped(map, disc ? from : 0.5 * (from + to));
    part.open_ends = object.open ? 3 : 0;
    const double height = circles.along * glm::length(to - from);
    if (disc) {
        const f64::Disk shape{circles.across * std::abs(n[6]), circles.across * std::abs(n[7]), 0.0,
                              0.0};
        return add_shape(scene_, shape, part);
    }
    if (cone) {
        const f64::Cone shape{circles.across * std::abs(n[3]), circles.across * std::abs(n[7]),
                              height, 0.0};
        return add_shape(scene_, shape, part);
    }
    return add_shape(scene_, f64::Cylinder{circles.across * std::abs(n[6]), height, 0.0, 0.0},
                     part);
}

Added PovSceneBuilder::place_torus(const PovObject& object, const glm::dmat4& map, Part& part) {
    const Circles circles = circles_of(map, {0.0, 1.0, 0.0});
    if (!circles.sound || std::abs(circles.along - circles.across) > rounding * circles.along) {
        return refused;
    }
    part.placement.position = mapped(map, glm::dvec3(0.0));
    part.placement.rotation = rotation_to(circles.axis);
    const f64::Torus shape{circles.along * std::abs(object.numbers[0]),
                           circles.along * std::abs(object.numbers[1]), 2.0 * std::numbers::pi,
                           0.0};
    return add_shape(scene_, shape, part);
}

// In the object's own frame the shape is sound; its triangles are then mapped.
void PovSceneBuilder::warped(const PovObject& object, const Around& here) {
    PovSceneBuilder::Around plain;
    Scene scratch;
    PovSceneBuilder(scratch, 1).draw(object, plain);
    Part part = part_of(object, here);
    const glm::dmat4 map = pov_to_world() * here.matrix * glm::inverse(pov_to_world());
    for (const Part& shape : scratch.parts) {
        const Box3 box = world_bounds(scratch, shape);
        const double sagitta = sagitta_part * glm::length(box.high - box.low);
        glm::dvec3 centre(0.0);
        Mesh baked =
            baked_mesh(triangles_of_part(scratch, shape, sagitta), glm::dmat3(map), centre);
        part.placement.position = glm::dvec3(map[3]) + centre;
        add_mesh_part(scene_, std::move(baked), part);
        const glm::dmat3 linear(map);
        const double stretch =
            std::sqrt(glm::dot(linear[0], linear[0]) + glm::dot(linear[1], linear[1]) +
                      glm::dot(linear[2], linear[2]));
        scene_.max_deviation_m = std::max(scene_.max_deviation_m, sagitta * stretch);
    }
    tally(object, scratch.parts.empty() ? "skipped" : "tessellated", stretched,
          scratch.parts.empty() ? Severity::loss : Severity::warning);
}

void PovSceneBuilder::draw(const PovObject& object, const Around& here) {
    const glm::dmat4 map = pov_to_world() * here.matrix;
    if (object.kind == PovKind::plane) {
        tally(object, "skipped", "endless planes are not drawn", Severity::note);
        return;
    }
    if (object.kind == PovKind::algebraic) {
        algebraic(object, here);
        return;
    }
    if (object.kind == PovKind::mesh) {
        mesh(object, here);
        return;
    }
    Part part = part_of(object, here);
    Added added = refused;
    switch (object.kind) {
        case PovKind::sphere: added = place_sphere(object, map, part); break;
        case PovKind::box: added = place_box(object, map, part); break;
        case PovKind::torus: added = place_torus(object, map, part); break;
        default: added = place_round(object, map, part); break;
    }
    if (!added.drawn && added.reason == stretched) {
        scene_.nodes.pop_back();
        warped(object, here);
    } else if (added.drawn) {
        const bool clipped = !here.clips.empty();
        tally(object, "analytic", clipped ? "limits of solids are not carried out" : added.reason,
              clipped ? Severity::warning : Severity::note);
    } else {
        tally(object, "skipped", added.reason, Severity::loss);
    }
}

void PovSceneBuilder::mesh(const PovObject& object, const Around& here) {
    Triangles triangles;
    triangles.positions.assign(object.mesh.positions.begin(), object.mesh.positions.end());
    triangles.indices = object.mesh.indices;
    const bool sound =
        std::all_of(triangles.indices.begin(), triangles.indices.end(),
                    [&](std::uint32_t index) { return index < triangles.positions.size(); });
    if (!sound || triangles.indices.empty()) {
        tally(object, "skipped", "a triangle's corner is not among the vertices", Severity::loss);
        return;
    }
    triangles.normals.assign(triangles.positions.size(), glm::dvec3(0.0));
    if (object.mesh.normals.size() == triangles.positions.size()) {
        triangles.normals.assign(object.mesh.normals.begin(), object.mesh.normals.end());
    } else {
        for (std::size_t i = 0; i < triangles.indices.size(); i += 3) {
            const auto corner = [&](std::size_t k) {
                return triangles.positions[triangles.indices[i + k]];
            };
            const glm::dvec3 area = glm::cross(corner(1) - corner(0), corner(2) - corner(0));
            for (std::size_t k = 0; k < 3; ++k) {
                triangles.normals[triangles.indices[i + k]] += area;
            }
        }
    }
    const glm::dmat4 map = pov_to_world() * here.matrix;
    Part part = part_of(object, here);
    glm::dvec3 centre(0.0);
    Mesh baked = baked_mesh(triangles, glm::dmat3(map), centre);
    part.placement.position = glm::dvec3(map[3]) + centre;
    add_mesh_part(scene_, std::move(baked), part);
    tally(object, "triangles", "", Severity::note);
}

// A torus between two planes through its axis, both of which cut (an arc below half a turn) or
// either (above): as the exporter writes elbows.
bool PovSceneBuilder::torus_arc(const PovObject& object, const Around& here) {
    if (object.children.empty() || object.children[0].object->kind != PovKind::torus) {
        return false;
    }
    const PovObject& ring = *object.children[0].object;
    std::vector<PovPlaced> planes(object.children.begin() + 1, object.children.end());
    glm::dmat4 map = pov_to_world() * here.matrix;
    const glm::dmat4 ring_map = map * ring.matrix;
    const bool either = planes.size() == 1 && planes[0].object->kind == PovKind::group;
    if (either) {
        map = map * planes[0].object->matrix;
        planes = std::vector<PovPlaced>(planes[0].object->children);
    }
    const glm::dvec3 axis = circles_of(ring_map, {0.0, 1.0, 0.0}).axis;
    std::vector<glm::dvec3> normals;
    for (const PovPlaced& plane : planes) {
        const glm::dmat4 back = glm::inverse(map * plane.object->matrix);
        if (plane.object->kind != PovKind::plane || std::abs(plane.object->numbers[3]) > rounding) {
            return false;
        }
        normals.push_back(
            glm::normalize(glm::transpose(glm::dmat3(back)) * vector_at(plane.object->numbers, 0)));
        if (!are_across(normals.back(), axis)) {
            return false;
        }
    }
    if (normals.size() != 2 || glm::length(glm::dvec3(ring_map[3] - map[3])) > rounding) {
        return false;
    }
    const auto angle = [&](const glm::dvec3& a, const glm::dvec3& b) {
        const double turn = std::atan2(glm::dot(glm::cross(a, b), axis), glm::dot(a, b));
        return turn < 0.0 ? turn + 2.0 * std::numbers::pi : turn;
    };
    // The arc goes from the plane that faces against the turn to the one that faces along it.
    glm::dvec3 from = glm::cross(-normals[0], axis);
    double arc = angle(from, glm::cross(normals[1], axis));
    if ((arc > std::numbers::pi + rounding) != either) {
        from = glm::cross(-normals[1], axis);
        arc = angle(from, glm::cross(normals[0], axis));
    }
    Around inside = here;
    inside.matrix = here.matrix * ring.matrix;
    inside.colour = ring.colour ? ring.colour : here.colour;
    Part part = part_of(ring, inside);
    const double scale = circles_of(ring_map, {0.0, 1.0, 0.0}).along;
    part.placement.position = glm::dvec3(ring_map[3]);
    part.placement.rotation =
        glm::normalize(glm::quat_cast(glm::dmat3(from, glm::cross(axis, from), axis)));
    const f64::Torus shape{scale * std::abs(ring.numbers[0]), scale * std::abs(ring.numbers[1]),
                           arc, 0.0};
    const Added added = add_shape(scene_, shape, part);
    tally(ring, added.drawn ? "analytic" : "skipped", added.reason,
          added.drawn ? Severity::note : Severity::loss);
    return true;
}

}  // namespace quartic
