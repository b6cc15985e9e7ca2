// Tessellates any shape that has faces through its point() alone: steps by sagitta, normals by
// differences.
#include "primitives/tessellate.h"

#include "primitives/tessellate_implicit.h"

#include <algorithm>
#include <cmath>

namespace quartic {
namespace {

constexpr int steps_max = 4096;
constexpr int steps_of_closed_line = 3;
constexpr double difference = 1e-6;  // of the parameters: normals are good to about as many radians
constexpr int line_count = 8;        // parameter lines that are tried in each direction
constexpr double flatness =
    1e-12;  // a curve or triangle this much thinner than long is straight or nothing

// One face of a shape as a map from the unit square.
template <class Shape>
struct Patch {
    const Shape& shape;
    int face;

    glm::dvec3 at(double u, double v) const { return f64().point(shape, face, {u, v}); }

    // A point of the line of constant v (along u) or of constant u.
    glm::dvec3 on_line(bool along_u, double line, double t) const {
        return along_u ? at(t, line) : at(line, t);
    }
};

double distance_to_chord(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b) {
    const glm::dvec3 chord = b - a;
    const double squared = glm::dot(chord, chord);
    const double t = squared > 0.0 ? std::clamp(glm::dot(p - a, chord) / squared, 0.0, 1.0) : 0.0;
    return glm::length(p - a - t * chord);
}

// How far a parameter line departs from its polyline of this many chords; a quarter and three
// quarters are tried besides the middle, because an S-shaped curve crosses its chord there.
template <class Shape>
double departure(const Patch<Shape>& patch, bool along_u, double line, int steps) {
    double worst = 0.0;
    glm::dvec3 a = patch.on_line(along_u, line, 0.0);
    for (int i = 0; i < steps; ++i) {
        const glm::dvec3 b = patch.on_line(along_u, line, double(i + 1) / steps);
        for (const double part : {0.25, 0.5, 0.75}) {
            const glm::dvec3 p = patch.on_line(along_u, line, (i + part) / steps);
            worst = std::max(worst, distance_to_chord(p, a, b));
        }
        a = b;
    }
    return worst;
}

struct Direction {
    bool along_u = true;
    bool curved = false;
    bool closed = false;
    double worst_line = 0.0;
};

// Finds the line of one direction that bends most.
template <class Shape>
Direction survey(const Patch<Shape>& patch, bool along_u) {
    Direction direction;
    direction.along_u = along_u;
    double worst = -1.0;
    double length = 0.0;
    for (int i = 0; i <= line_count; ++i) {
        const double line = double(i) / line_count;
        const double bend = departure(patch, along_u, line, 4);
        if (bend > worst) {
            worst = bend;
            direction.worst_line = line;
        }
        const glm::dvec3 start = patch.on_line(along_u, line, 0.0);
        length = std::max(length, glm::length(patch.on_line(along_u, line, 0.5) - start));
        length = std::max(length, glm::length(patch.on_line(along_u, line, 1.0) - start));
    }
    const glm::dvec3 gap = patch.on_line(along_u, direction.worst_line, 1.0) -
                           patch.on_line(along_u, direction.worst_line, 0.0);
    direction.curved = worst > 1e-9 * length;
    direction.closed = direction.curved && glm::length(gap) < 1e-9 * length;
    return direction;
}

// The steps that keep a direction within the sagitta: doubled until they do, then as many fewer as
// the excess allows.
template <class Shape>
int count_steps(const Patch<Shape>& patch, const Direction& direction, double sagitta) {
    if (!direction.curved) {
        return 1;
    }
    int steps = direction.closed ? 4 : 1;
    double bend = departure(patch, direction.along_u, direction.worst_line, steps);
    while (bend > sagitta && steps < steps_max) {
        steps *= 2;
        bend = departure(patch, direction.along_u, direction.worst_line, steps);
    }
    const int least = direction.closed ? steps_of_closed_line : 1;
    const double scale =
        std::sqrt(std::min(1.0, bend / sagitta));  // sagittas go with the square of the chord
    const int fewer = std::max(least, int(std::ceil(steps * scale)));
    const bool enough = fewer < steps &&
                        departure(patch, direction.along_u, direction.worst_line, fewer) <= sagitta;
    return enough ? fewer : steps;
}

// du x dv just inside the patch: at poles and tips one derivative vanishes on the border itself.
// Zero where one vanishes inside too.
template <class Shape>
glm::dvec3 cross_of_derivatives(const Patch<Shape>& patch, double u, double v) {
    const double h = difference;
    const double in_u = std::clamp(u, h, 1.0 - h);
    const double in_v = std::clamp(v, h, 1.0 - h);
    const glm::dvec3 along_u = patch.at(in_u + h, in_v) - patch.at(in_u - h, in_v);
    const glm::dvec3 along_v = patch.at(in_u, in_v + h) - patch.at(in_u, in_v - h);
    const double length_u = glm::length(along_u);
    const double length_v = glm::length(along_v);
    const glm::dvec3 normal = glm::cross(along_u, along_v);
    const bool sound = std::min(length_u, length_v) > 1e-8 * std::max(length_u, length_v) &&
                       glm::length(normal) > 1e-9 * length_u * length_v;
    return sound ? glm::normalize(normal) : glm::dvec3(0.0);
}

template <class Shape>
glm::dvec3 normal_at(const Patch<Shape>& patch, double u, double v) {
    // A torus of R = r has a singular point in the middle of its patch: its neighbour's normal must
    // do.
    for (const double aside : {0.0, 1e-4, 1e-2}) {
        const glm::dvec3 normal = cross_of_derivatives(patch, u, v < 0.75 ? v + aside : v - aside);
        if (normal != glm::dvec3(0.0)) {
            return normal;
        }
    }
    return {0.0, 0.0, 1.0};
}

bool is_triangle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    const double longest =
        std::max({glm::dot(b - a, b - a), glm::dot(c - a, c - a), glm::dot(c - b, c - b)});
    return glm::length(glm::cross(b - a, c - a)) > flatness * longest;
}

void add_triangle(Triangles& triangles, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const std::vector<glm::dvec3>& p = triangles.positions;
    if (is_triangle(p[a], p[b], p[c])) {
        triangles.indices.insert(triangles.indices.end(), {a, b, c});
    }
}

template <class Shape>
void add_grid(Triangles& triangles, const Patch<Shape>& patch, int steps_u, int steps_v) {
    const std::size_t first_index = triangles.indices.size();
    const std::size_t first_position = triangles.positions.size();
    for (int j = 0; j <= steps_v; ++j) {
        for (int i = 0; i <= steps_u; ++i) {
            const double u = double(i) / steps_u;
            const double v = double(j) / steps_v;
            triangles.positions.push_back(patch.at(u, v));
            triangles.normals.push_back(normal_at(patch, u, v));
        }
    }
    const auto row = static_cast<std::uint32_t>(steps_u + 1);
    for (std::uint32_t j = 0; j < static_cast<std::uint32_t>(steps_v); ++j) {
        for (std::uint32_t i = 0; i + 1 < row; ++i) {
            const std::uint32_t a = static_cast<std::uint32_t>(first_position) + j * row + i;
            add_triangle(triangles, a, a + 1, a + row + 1);
            add_triangle(triangles, a, a + row + 1, a + row);
        }
    }
    if (triangles.indices.size() == first_index) {  // a face without area
        triangles.positions.resize(first_position);
        triangles.normals.resize(first_position);
    }
}

template <class Shape>
Triangles tessellate_faces(const Shape& shape, double sagitta, int open_ends) {
    CHECK(sagitta > 0.0);
    Triangles triangles;
    const int ends = f64().end_count(shape);
    for (int face = 0; face < f64().face_count(shape); ++face) {
        if (face >= 1 && face <= ends && f64().is_open(open_ends, face - 1)) {
            continue;
        }
        const Patch<Shape> patch{shape, face};
        const Direction u = survey(patch, true);
        const Direction v = survey(patch, false);
        // Where both directions bend, their departures add up.
        const double each = u.curved && v.curved ? 0.5 * sagitta : sagitta;
        add_grid(triangles, patch, count_steps(patch, u, each), count_steps(patch, v, each));
    }
    return triangles;
}

f64::Polynomial along(const f64::CubicSurface& shape, const glm::dvec3& p, const glm::dvec3& v) {
    return f64().cubic_along(f64().coefficients(shape), p / shape.half_size, v / shape.half_size);
}

f64::Polynomial along(const f64::QuarticSurface& shape, const glm::dvec3& p, const glm::dvec3& v) {
    return f64().quartic_along(f64().coefficients(shape), p / shape.half_size, v / shape.half_size);
}

template <class Shape>
Triangles tessellate_zeros(const Shape& shape, double sagitta) {
    ImplicitSurface surface;
    surface.value = [&](const glm::dvec3& p) { return f64().value(shape, p); };
    surface.gradient = [&](const glm::dvec3& p) { return f64().gradient(shape, p); };
    surface.half_size = shape.half_size;
    surface.row = [&](const glm::dvec3& p, const glm::dvec3& v, std::span<double> values) {
        const f64::Polynomial line = along(shape, p, v);
        for (std::size_t i = 0; i < values.size(); ++i) {
            values[i] = f64().value_at(line, double(i) / double(values.size() - 1));
        }
    };
    return tessellate_implicit(surface, sagitta);
}

}  // namespace

#define SHAPE(id, Type, name)                                                     \
    Triangles tessellate(const f64::Type& shape, double sagitta, int open_ends) { \
        if constexpr (Implicit<f64::Type>) {                                      \
            return tessellate_zeros(shape, sagitta);                              \
        } else {                                                                  \
            return tessellate_faces(shape, sagitta, open_ends);                   \
        }                                                                         \
    }
#include "primitives/catalog.h"
#undef SHAPE

}  // namespace quartic
