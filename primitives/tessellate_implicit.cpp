// Marching tetrahedra (Doi and Koide 1991) on the six tetrahedra of each cell that share its main
// diagonal, so that cells fit together.
#include "primitives/tessellate_implicit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>
#include <utility>

namespace quartic {
namespace {

constexpr int steps_first = 24;
constexpr int root_steps_max = 60;
constexpr double root_tolerance = 1e-13;  // of an edge
constexpr double near_corner = 1e-9;      // of an edge: the vertex is the grid's

// Corners of a cell are numbered by bits: 1 along x, 2 along y, 4 along z. Each tetrahedron goes
// from corner 0 to 7 along the axes in one of their orders.
constexpr std::array<std::array<int, 4>, 6> tetrahedra{
    {{0, 1, 3, 7}, {0, 1, 5, 7}, {0, 2, 3, 7}, {0, 2, 6, 7}, {0, 4, 5, 7}, {0, 4, 6, 7}}};

class Marching {
public:
    Marching(const ImplicitSurface& surface, int steps)
        : surface_(surface), steps_(static_cast<std::size_t>(steps)) {}

    Triangles run();

private:
    glm::dvec3 place(std::size_t point) const;
    void sample();
    void march_cell(std::size_t origin);
    void march(const std::array<std::size_t, 4>& corners);
    std::uint32_t vertex(std::size_t a, std::size_t b);
    glm::dvec3 root_between(std::size_t a, std::size_t b, double& t) const;
    void add_triangle(std::array<std::uint32_t, 3> corners, const glm::dvec3& outwards);
    void finish();
    void measure();

    std::size_t point_at(std::size_t i, std::size_t j, std::size_t k) const {
        return (k * (steps_ + 1) + j) * (steps_ + 1) + i;
    }
    std::size_t offset_of(int corner) const {
        return point_at(std::size_t(corner & 1), std::size_t((corner >> 1) & 1),
                        std::size_t(corner >> 2));
    }
    double step() const { return 2.0 * surface_.half_size / static_cast<double>(steps_); }

    const ImplicitSurface& surface_;
    std::size_t steps_;
    std::vector<double> values_;
    std::vector<double> slopes_;  // lengths of the gradients at the vertices
    // Vertices by the two grid points of their edge.
    struct PairHash {
        std::size_t operator()(const std::pair<std::size_t, std::size_t>& pair) const {
            return pair.first * 0x9e3779b97f4a7c15u ^ (pair.second * 0xc2b2ae3d27d4eb4fu);
        }
    };
    std::unordered_map<std::pair<std::size_t, std::size_t>, std::uint32_t, PairHash> vertices_;
    Triangles triangles_;
};

glm::dvec3 Marching::place(std::size_t point) const {
    const std::size_t side = steps_ + 1;
    const glm::dvec3 cell(double(point % side), double(point / side % side),
                          double(point / side / side));
    return surface_.half_size * (2.0 * cell / double(steps_) - 1.0);
}

void Marching::sample() {
    const std::size_t side = steps_ + 1;
    values_.resize(side * side * side);
    const glm::dvec3 along(2.0 * surface_.half_size, 0.0, 0.0);
    for (std::size_t first = 0; first < values_.size(); first += side) {
        const std::span<double> row = std::span(values_).subspan(first, side);
        if (surface_.row) {
            surface_.row(place(first), along, row);
            continue;
        }
        for (std::size_t i = 0; i < side; ++i) {
            row[i] = surface_.value(place(first + i));
        }
    }
}

// The sign change on an edge, by false position in Illinois' form (Dowell and Jarratt 1971).
glm::dvec3 Marching::root_between(std::size_t a, std::size_t b, double& t) const {
    const glm::dvec3 from = place(a);
    const glm::dvec3 along = place(b) - from;
    double low = 0.0;
    double high = 1.0;
    double f_low = values_[a];
    double f_high = values_[b];
    int side = 0;  // which end was moved last
    for (int i = 0; i < root_steps_max; ++i) {
        // Now and then the middle: false position alone may creep along a double root.
        const double secant = low + (high - low) * (f_low / (f_low - f_high));
        const double before =
            std::exchange(t, i % 8 == 7 ? 0.5 * (low + high) : std::clamp(secant, low, high));
        if (i > 0 && std::abs(t - before) < root_tolerance) {
            break;
        }
        const double f = surface_.value(from + t * along);
        const bool at_low = (f < 0.0) == (values_[a] < 0.0);
        (at_low ? low : high) = t;
        (at_low ? f_low : f_high) = f;
        if (f == 0.0) {
            break;
        }
        (at_low ? f_high : f_low) *= side == (at_low ? 1 : 2) ? 0.5 : 1.0;
        side = at_low ? 1 : 2;
    }
    return from + t * along;
}

std::uint32_t Marching::vertex(std::size_t a, std::size_t b) {
    const std::pair<std::size_t, std::size_t> edge = std::minmax(a, b);
    if (const auto found = vertices_.find(edge); found != vertices_.end()) {
        return found->second;
    }
    double t = 0.5;
    glm::dvec3 position = root_between(edge.first, edge.second, t);
    const bool at_first = t < near_corner;
    std::uint32_t number = static_cast<std::uint32_t>(triangles_.positions.size());
    if (at_first || t > 1.0 - near_corner) {
        // All edges that end in a grid point of the surface share one vertex.
        const std::size_t corner = at_first ? edge.first : edge.second;
        position = place(corner);
        number = vertices_.try_emplace({corner, corner}, number).first->second;
    }
    if (number == triangles_.positions.size()) {
        triangles_.positions.push_back(position);
    }
    vertices_.emplace(edge, number);
    return number;
}

void Marching::add_triangle(std::array<std::uint32_t, 3> corners, const glm::dvec3& outwards) {
    if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) {
        return;
    }
    const std::vector<glm::dvec3>& p = triangles_.positions;
    const glm::dvec3 area =
        glm::cross(p[corners[1]] - p[corners[0]], p[corners[2]] - p[corners[0]]);
    if (glm::dot(area, outwards) < 0.0) {
        std::swap(corners[1], corners[2]);
    }
    triangles_.indices.insert(triangles_.indices.end(), corners.begin(), corners.end());
}

// One, or two triangles between the corners that are inside (negative) and those outside.
void Marching::march(const std::array<std::size_t, 4>& corners) {
    std::array<std::size_t, 4> sorted{};
    std::size_t inside = 0;
    std::size_t outside = 4;
    for (const std::size_t corner : corners) {
        sorted[values_[corner] < 0.0 ? inside++ : --outside] = corner;
    }
    if (inside == 0 || inside == 4) {
        return;
    }
    const glm::dvec3 outwards = [&] {
        glm::dvec3 sum(0.0);
        for (std::size_t i = 0; i < 4; ++i) {
            sum +=
                (i < inside ? -1.0 / double(inside) : 1.0 / double(4 - inside)) * place(sorted[i]);
        }
        return sum;
    }();
    if (inside == 2) {
        const std::uint32_t a = vertex(sorted[0], sorted[2]);
        const std::uint32_t b = vertex(sorted[0], sorted[3]);
        const std::uint32_t c = vertex(sorted[1], sorted[3]);
        const std::uint32_t d = vertex(sorted[1], sorted[2]);
        add_triangle({a, b, c}, outwards);
        add_triangle({a, c, d}, outwards);
        return;
    }
    const std::size_t tip = inside == 1 ? sorted[0] : sorted[3];
    const std::size_t base = inside == 1 ? 1 : 0;
    add_triangle(
        {vertex(tip, sorted[base]), vertex(tip, sorted[base + 1]), vertex(tip, sorted[base + 2])},
        outwards);
}

void Marching::march_cell(std::size_t origin) {
    bool negative = false;
    bool positive = false;
    for (int corner = 0; corner < 8; ++corner) {
        const bool below = values_[origin + offset_of(corner)] < 0.0;
        negative = negative || below;
        positive = positive || !below;
    }
    if (!negative || !positive) {
        return;
    }
    for (const std::array<int, 4>& tetrahedron : tetrahedra) {
        std::array<std::size_t, 4> corners{};
        std::transform(tetrahedron.begin(), tetrahedron.end(), corners.begin(),
                       [&](int corner) { return origin + offset_of(corner); });
        march(corners);
    }
}

// Normals: of the gradient; at a singular point of the triangles around it.
void Marching::finish() {
    std::vector<glm::dvec3> areas(triangles_.positions.size(), glm::dvec3(0.0));
    const auto& p = triangles_.positions;
    for (std::size_t i = 0; i < triangles_.indices.size(); i += 3) {
        const std::uint32_t* const corner = &triangles_.indices[i];
        const glm::dvec3 area =
            glm::cross(p[corner[1]] - p[corner[0]], p[corner[2]] - p[corner[0]]);
        for (std::size_t k = 0; k < 3; ++k) {
            areas[corner[k]] += area;
        }
    }
    for (std::size_t i = 0; i < p.size(); ++i) {
        const glm::dvec3 gradient = surface_.gradient(p[i]);
        const double length = glm::length(gradient);
        slopes_.push_back(length);
        const double area = glm::length(areas[i]);
        const glm::dvec3 otherwise = area > 0.0 ? areas[i] / area : glm::dvec3(0.0, 0.0, 1.0);
        triangles_.normals.push_back(length > 1e-12 ? gradient / length : otherwise);
    }
}

// How far the middles of triangles and of their longest edges lie from the surface, to first order
// (Taubin 1991) with the corners' mean slope, and never more than a cell is wide.
void Marching::measure() {
    const double cell = std::sqrt(3.0) * step();
    const auto depart = [&](const glm::dvec3& at, double slope) {
        const double value = std::abs(surface_.value(at));
        const double distance = value < cell * slope ? value / slope : (value > 0.0 ? cell : 0.0);
        triangles_.deviation = std::max(triangles_.deviation, distance);
    };
    const auto& p = triangles_.positions;
    for (std::size_t i = 0; i < triangles_.indices.size(); i += 3) {
        const std::uint32_t* const corner = &triangles_.indices[i];
        glm::dvec3 middle(0.0);
        double longest = -1.0;
        double slope = 0.0;
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::dvec3& a = p[corner[k]];
            const glm::dvec3& b = p[corner[(k + 1) % 3]];
            if (glm::dot(b - a, b - a) > longest) {
                longest = glm::dot(b - a, b - a);
                middle = 0.5 * (a + b);
            }
            slope += slopes_[corner[k]] / (3.0 * surface_.half_size);
        }
        depart((p[corner[0]] + p[corner[1]] + p[corner[2]]) / 3.0, slope);
        depart(middle, slope);
    }
}

Triangles Marching::run() {
    sample();
    for (std::size_t k = 0; k < steps_; ++k) {
        for (std::size_t j = 0; j < steps_; ++j) {
            for (std::size_t i = 0; i < steps_; ++i) {
                march_cell(point_at(i, j, k));
            }
        }
    }
    finish();
    measure();
    return std::move(triangles_);
}

}  // namespace

// Departures go with the square of the step where the surface is smooth, with the step at
// singular points: finer grids would hardly help there, and cost eight times as much.
Triangles tessellate_implicit(const ImplicitSurface& surface, double sagitta) {
    CHECK(sagitta > 0.0);
    int steps = steps_first;
    double before = -1.0;
    for (;;) {
        Triangles triangles = Marching(surface, steps).run();
        const bool singular = before >= 0.0 && triangles.deviation > before;
        if (triangles.deviation <= sagitta || steps >= implicit_steps_max || singular) {
            return triangles;
        }
        const double finer = 1.15 * std::sqrt(triangles.deviation / sagitta);
        const int next = std::min(implicit_steps_max,
                                  static_cast<int>(std::ceil(steps * std::clamp(finer, 1.3, 2.7))));
        before = 2.0 * triangles.deviation * steps * steps / (next * next);
        steps = next;
    }
}

}  // namespace quartic
