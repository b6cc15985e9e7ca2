// Parts as POV-Ray's statements, each in its own frame with a matrix behind it.
#include "exporters/pov.h"

#include "primitives/tessellate.h"
#include "scene/algebraic_surface.h"
#include "scene/camera.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>
#include <span>
#include <string>

namespace quartic {
namespace {

constexpr double fine_sagitta = 0.0005;  // metres
constexpr double fine_part = 1e-3;       // of a shape's size, where that is more
constexpr double full_turn = 2.0 * std::numbers::pi;

// The shortest text that reads back as the same number.
std::string text_of(double number) {
    std::array<char, 32> text{};
    const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), number);
    return std::string(text.data(), end);
}

std::string text_of(const glm::dvec3& v) {
    return "<" + text_of(v.x) + "," + text_of(v.y) + "," + text_of(v.z) + ">";
}

// Ours (x right, y away, z up) and POV-Ray's (x right, y up, z away).
glm::dvec3 swapped(const glm::dvec3& v) {
    return {v.x, v.z, v.y};
}

// Comments end with their line.
std::string comment_of(std::string_view text) {
    std::string comment;
    for (const char c : text) {
        comment += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
    }
    return comment;
}

class Export {
public:
    Export(const Scene& scene, Output& output) : scene_(scene), output_(output) {}

    void run();

private:
    void write_header();
    void write_view();
    void write_part(const Part& part);
    std::string end_of(const Part& part, double scale) const;

    void write(const f64::Sphere& shape, const Part& part);
    void write(const f64::Cylinder& shape, const Part& part);
    void write(const f64::Cone& shape, const Part& part);
    void write(const f64::Torus& shape, const Part& part);
    void write(const f64::Box& shape, const Part& part);
    void write(const f64::Disk& shape, const Part& part);
    void write(const f64::CubicSurface& shape, const Part& part);
    void write(const f64::QuarticSurface& shape, const Part& part);
    template <class Shape>
    void write(const Shape& shape, const Part& part);  // as triangles
    void write_surface(std::string_view word, std::span<const double> terms, double half_size,
                       const Part& part);
    template <class Vector>
    void write_mesh(std::span<const Vector> positions, std::span<const Vector> normals,
                    std::span<const std::uint32_t> indices, const Part& part);

    const Scene& scene_;
    Output& output_;
};

void Export::write_header() {
    output_.write("// " + comment_of(scene_.title) + "\n// Written by Quartic, in metres.\n");
    output_.write("#version 3.7;\nglobal_settings { assumed_gamma 1.0 }\n");
    for (std::size_t i = 0; i < scene_.materials.size(); ++i) {
        const Material& material = scene_.materials[i];
        const glm::dvec4 c(material.colour);
        output_.write("\n// " + comment_of(material.name) + "\n#declare Material_" +
                      std::to_string(i) + " = texture { pigment { color rgbt <" + text_of(c.r) +
                      "," + text_of(c.g) + "," + text_of(c.b) + "," + text_of(1.0 - c.a) +
                      "> } finish { ambient 0.15 diffuse 0.75 specular 0.3 roughness 0.02 } }\n");
    }
    output_.write("\n");
}

// A view of everything from the front, right and above.
void Export::write_view() {
    constexpr PixelSize size{4, 3};
    const Box3 box = world_bounds(scene_, {true, true, true, true});
    if (box.empty()) {
        return;
    }
    const Camera camera = find_camera("iso", box, Camera{}, size).value_or(Camera{});
    output_.write("camera {\n  location " + text_of(swapped(camera.eye)) +
                  "\n  right x*image_width/image_height\n  angle " +
                  text_of(glm::degrees(camera.fov_y) * 4.0 / 3.0) + "\n  look_at " +
                  text_of(swapped(camera.target)) + "\n}\n");
    const glm::dvec3 reach = camera.eye - camera.target;
    const glm::dvec3 light = camera.target + 3.0 * reach + glm::dvec3(0.0, 0.0, glm::length(reach));
    output_.write("light_source { " + text_of(swapped(light)) + ", rgb 1 }\n");
    output_.write("background { color rgb <0.9,0.92,0.95> }\n");
}

// What stands behind a shape in its own frame: where it is and what it is made of.
std::string Export::end_of(const Part& part, double scale) const {
    const glm::dmat3 axes = scale * glm::mat3_cast(part.placement.rotation);
    std::string text = " matrix <";
    for (int column = 0; column < 3; ++column) {
        const glm::dvec3 axis = swapped(axes[column]);
        text += text_of(axis.x) + "," + text_of(axis.y) + "," + text_of(axis.z) + ",";
    }
    const glm::dvec3 p = swapped(part.placement.position);
    text += text_of(p.x) + "," + text_of(p.y) + "," + text_of(p.z) + ">";
    if (part.material < scene_.materials.size()) {
        text += " texture { Material_" + std::to_string(part.material) + " }";
    }
    return text + " }\n";
}

void Export::write(const f64::Sphere& shape, const Part& part) {
    output_.write("sphere { 0, " + text_of(shape.radius) + end_of(part, 1.0));
}

void Export::write(const f64::Cylinder& shape, const Part& part) {
    const std::string half = text_of(0.5 * shape.height);
    output_.write("cylinder { <0,0,-" + half + ">, <0,0," + half + ">, " + text_of(shape.radius) +
                  (part.open_ends == 3 ? " open" : "") + end_of(part, 1.0));
}

void Export::write(const f64::Cone& shape, const Part& part) {
    const std::string half = text_of(0.5 * shape.height);
    output_.write("cone { <0,0,-" + half + ">, " + text_of(shape.bottom_radius) + ", <0,0," + half +
                  ">, " + text_of(shape.top_radius) + (part.open_ends == 3 ? " open" : "") +
                  end_of(part, 1.0));
}

// POV-Ray's torus lies around y. An arc up to half a turn is what both of two half-spaces hold, a
// longer one what either of them holds.
void Export::write(const f64::Torus& shape, const Part& part) {
    const std::string ring =
        "torus { " + text_of(shape.bend_radius) + ", " + text_of(shape.radius) + " rotate 90*x";
    if (shape.arc >= full_turn) {
        output_.write(ring + end_of(part, 1.0));
        return;
    }
    const bool either = shape.arc > std::numbers::pi;
    const glm::dvec3 end(-std::sin(shape.arc), std::cos(shape.arc), 0.0);
    output_.write("intersection { " + ring + " }" + (either ? " union {" : "") +
                  " plane { <0,-1,0>, 0 } plane { " + text_of(end) + ", 0 }" +
                  (either ? " }" : "") + end_of(part, 1.0));
}

void Export::write(const f64::Box& shape, const Part& part) {
    const glm::dvec3 half = 0.5 * glm::dvec3(shape.length_x, shape.length_y, shape.length_z);
    output_.write("box { " + text_of(-half) + ", " + text_of(half) + end_of(part, 1.0));
}

void Export::write(const f64::Disk& shape, const Part& part) {
    output_.write("disc { 0, z, " + text_of(shape.radius) +
                  (shape.inner_radius > 0.0 ? ", " + text_of(shape.inner_radius) : "") +
                  end_of(part, 1.0));
}

void Export::write_surface(std::string_view word, std::span<const double> terms, double half_size,
                           const Part& part) {
    std::string list;
    for (std::size_t i = 0; i < terms.size(); ++i) {
        list += (i == 0 ? "" : (i % 10 == 0 ? ",\n    " : ",")) + text_of(terms[i]);
    }
    output_.write(std::string(word) + " {\n  < " + list +
                  " >\n  sturm clipped_by { box { -1, 1 } } bounded_by { clipped_by }" +
                  end_of(part, half_size));
}

void Export::write(const f64::CubicSurface& shape, const Part& part) {
    write_surface("cubic", polynomial_of(shape).cubic_terms(), shape.half_size, part);
}

void Export::write(const f64::QuarticSurface& shape, const Part& part) {
    write_surface("quartic", polynomial_of(shape).terms(), shape.half_size, part);
}

template <class Vector>
void Export::write_mesh(std::span<const Vector> positions, std::span<const Vector> normals,
                        std::span<const std::uint32_t> indices, const Part& part) {
    if (indices.empty()) {
        return;
    }
    output_.write("mesh2 {\n");
    for (const bool vertices : {true, false}) {
        output_.write(std::string(vertices ? "  vertex" : "  normal") + "_vectors { " +
                      std::to_string(positions.size()));
        for (const Vector& v : vertices ? positions : normals) {
            output_.write(",\n    " + text_of(glm::dvec3(v)));
        }
        output_.write(" }\n");
    }
    output_.write("  face_indices { " + std::to_string(indices.size() / 3));
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
        output_.write(",\n    <" + std::to_string(indices[i]) + "," +
                      std::to_string(indices[i + 1]) + "," + std::to_string(indices[i + 2]) + ">");
    }
    output_.write(" }\n " + end_of(part, 1.0));
}

template <class Shape>
void Export::write(const Shape& shape, const Part& part) {
    const f64::Bounds box = f64().bounds(shape);
    const double sagitta = std::max(fine_sagitta, fine_part * glm::length(box.high - box.low));
    const Triangles triangles = tessellate(shape, sagitta, part.open_ends);
    write_mesh<glm::dvec3>(triangles.positions, triangles.normals, triangles.indices, part);
}

// The node's name stands above the object, as a comment.
void Export::write_part(const Part& part) {
    if (part.node < scene_.nodes.size()) {
        output_.write("// " + comment_of(scene_.strings[scene_.nodes[part.node].name]) + "\n");
    }
    if (part.type == ShapeType::mesh) {
        const Mesh& mesh = scene_.meshes[part.shape];
        write_mesh<glm::vec3>(mesh.positions, mesh.normals, mesh.indices, part);
    } else {
        visit_shape(scene_.shapes, part.type, part.shape,
                    [&](const auto& shape) { write(shape, part); });
    }
}

void Export::run() {
    write_header();
    for (const Part& part : scene_.parts) {
        if (part.layer != Layer::line) {
            write_part(part);
        }
    }
    write_view();
}

}  // namespace

void remark_pov(const Scene& scene, Findings& findings) {
    std::uint64_t count = 0;
    for (const Part& part : scene.parts) {
        count += part.type == ShapeType::dish || part.type == ShapeType::snout ||
                 part.type == ShapeType::rectangular_torus || part.type == ShapeType::pyramid;
    }
    if (count > 0) {
        findings.add(Severity::note, "POV-Ray",
                     "dishes, snouts, rectangular tori and pyramids: written as triangles", count);
    }
}

Status export_pov(const Scene& scene, Output& output) {
    Export(scene, output).run();
    return Done{};
}

}  // namespace quartic
