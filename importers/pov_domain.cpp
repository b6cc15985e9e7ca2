// Limits as boxes in one frame.
#include "importers/pov_domain.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace quartic {
namespace {

constexpr double endless = std::numeric_limits<double>::infinity();
constexpr double rounding = 1e-9;
constexpr int cubes_max = 27;

glm::dvec3 vector_at(const std::vector<double>& numbers, std::size_t at) {
    return {numbers[at], numbers[at + 1], numbers[at + 2]};
}

// A limit behind the names and transformations around it.
PovPlaced resolved(PovPlaced limit) {
    for (int depth = 0; depth < pov_depth_max; ++depth) {
        const PovObject& object = *limit.object;
        limit.matrix = limit.matrix * object.matrix;
        if (object.kind != PovKind::group || object.children.size() != 1) {
            break;
        }
        const PovPlaced inner = object.children[0];
        limit = {inner.object, limit.matrix * inner.matrix};
    }
    return limit;
}

Box3 everywhere() {
    return {glm::dvec3(-endless), glm::dvec3(endless)};
}

// Around a ball in the limit's own coordinates.
Box3 around(const glm::dmat4& map, const glm::dvec3& centre, double radius) {
    const glm::dvec3 middle(map * glm::dvec4(centre, 1.0));
    const glm::dmat3 rows = glm::transpose(glm::dmat3(map));
    const glm::dvec3 reach(glm::length(rows[0]), glm::length(rows[1]), glm::length(rows[2]));
    return {middle - std::abs(radius) * reach, middle + std::abs(radius) * reach};
}

Box3 joined(const Box3& a, const Box3& b) {
    return {glm::min(a.low, b.low), glm::max(a.high, b.high)};
}

// Of each coordinate, what the circles across the axis reach.
Box3 around_cylinder(const glm::dmat4& map, const std::vector<double>& numbers) {
    const glm::dvec3 from = vector_at(numbers, 0);
    const glm::dvec3 to = vector_at(numbers, 3);
    const glm::dvec3 axis = glm::normalize(to - from);
    const glm::dmat3 rows = glm::transpose(glm::dmat3(map));
    glm::dvec3 reach(0.0);
    for (int i = 0; i < 3; ++i) {
        reach[i] = std::abs(numbers[6]) * glm::length(rows[i] - glm::dot(rows[i], axis) * axis);
    }
    const glm::dvec3 a(map * glm::dvec4(from, 1.0));
    const glm::dvec3 b(map * glm::dvec4(to, 1.0));
    return {glm::min(a, b) - reach, glm::max(a, b) + reach};
}

Box3 of_corners(const glm::dmat4& map, const glm::dvec3& a, const glm::dvec3& b) {
    Box3 box;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 at((corner & 1) != 0 ? b.x : a.x, (corner & 2) != 0 ? b.y : a.y,
                            (corner & 4) != 0 ? b.z : a.z);
        const glm::dvec3 p(map * glm::dvec4(at, 1.0));
        box = joined(box, {p, p});
    }
    return box;
}

// The side of a plane that is across an axis; everywhere for others.
Box3 of_plane(const glm::dmat4& map, const std::vector<double>& numbers) {
    const glm::dmat4 back = glm::inverse(map);
    const glm::dvec3 normal = glm::normalize(vector_at(numbers, 0));
    const glm::dvec3 across = glm::transpose(glm::dmat3(back)) * normal;
    const double distance = numbers[3] - glm::dot(normal, glm::dvec3(back[3]));
    Box3 box = everywhere();
    for (int axis = 0; axis < 3; ++axis) {
        if (std::abs(across[axis]) > (1.0 - rounding) * glm::length(across)) {
            (across[axis] > 0.0 ? box.high : box.low)[axis] = distance / across[axis];
        }
    }
    return box;
}

// Whether axes stay parallel to axes.
bool is_level(const glm::dmat4& map) {
    const auto along_one = [&](int column) {
        const glm::dvec3 v = glm::abs(glm::dvec3(map[column]));
        return std::max({v.x, v.y, v.z}) > (1.0 - rounding) * (v.x + v.y + v.z);
    };
    return along_one(0) && along_one(1) && along_one(2);
}

struct Limit {
    Box3 box = everywhere();
    std::string_view remark;
};

Limit limit_of(const PovObject& object, const glm::dmat4& map) {
    constexpr std::string_view round = "a round limit: clipped by the box around it";
    constexpr std::string_view ignored = "a limit that is no box, ball, cylinder or level plane";
    const std::vector<double>& n = object.numbers;
    if (object.inverse) {
        return {everywhere(), "a limit that is cut out: not carried out"};
    }
    if (object.kind == PovKind::box) {
        return {
            of_corners(map, vector_at(n, 0), vector_at(n, 3)),
            is_level(map) ? std::string_view() : "a turned limit: clipped by the box around it"};
    }
    if (object.kind == PovKind::sphere) {
        return {around(map, vector_at(n, 0), n[3]), round};
    }
    if (object.kind == PovKind::cylinder) {
        return {around_cylinder(map, n), round};
    }
    if (object.kind == PovKind::plane) {
        const Box3 side = of_plane(map, n);
        const bool level = side.low != glm::dvec3(-endless) || side.high != glm::dvec3(endless);
        return {side, level ? std::string_view() : ignored};
    }
    return {everywhere(), ignored};
}

}  // namespace

glm::dmat4 pov_to_world() {
    glm::dmat4 swap(0.0);
    swap[0][0] = swap[1][2] = swap[2][1] = swap[3][3] = 1.0;
    return swap;
}

glm::dmat3 orthonormal(const glm::dmat3& matrix) {
    const glm::dvec3 x = glm::normalize(matrix[0]);
    const glm::dvec3 y = glm::normalize(matrix[1] - glm::dot(matrix[1], x) * x);
    return {x, y, glm::cross(x, y)};
}

PovDomain domain_of(std::span<const PovPlaced> limits, const glm::dmat3& axes) {
    std::vector<PovPlaced> all;
    for (const PovPlaced& limit : limits) {
        all.push_back(resolved(limit));
    }
    PovDomain domain;
    domain.axes = axes;
    const auto first = std::find_if(all.begin(), all.end(), [](const PovPlaced& limit) {
        return limit.object->kind == PovKind::box;
    });
    if (first != all.end()) {
        domain.axes = orthonormal(glm::dmat3(pov_to_world() * first->matrix));
    }
    domain.box = everywhere();
    const glm::dmat4 to_axes = glm::dmat4(glm::transpose(domain.axes)) * pov_to_world();
    for (const PovPlaced& each : all) {
        const Limit limit = limit_of(*each.object, to_axes * each.matrix);
        domain.box.low = glm::max(domain.box.low, limit.box.low);
        domain.box.high = glm::min(domain.box.high, limit.box.high);
        domain.remark = limit.remark.empty() ? domain.remark : limit.remark;
    }
    return domain;
}

// Grids in cubes, each twice as wide as the one before: a cell where the sign changes counts at the
// finest grid that covers it. The surface is closed if none lies at the faces of the last cube.
PovExtent extent_of(const Polynomial3& polynomial) {
    constexpr int steps = 24;
    constexpr double half_first = 1.5;
    constexpr double half_last = 48.0;
    Box3 box;
    for (double half = half_first; half <= half_last; half *= 2.0) {
        const double step = 2.0 * half / steps;
        const double covered = half > half_first ? 0.5 * half : 0.0;
        const auto place = [&](int i) { return -half + step * (i + 0.493); };
        for (int i = 0; i < steps * steps * steps; ++i) {
            const glm::dvec3 at(place(i % steps), place(i / steps % steps),
                                place(i / steps / steps));
            if (std::max({std::abs(at.x), std::abs(at.y), std::abs(at.z)}) < covered) {
                continue;
            }
            const bool inside = polynomial.value(at) < 0.0;
            for (int axis = 0; axis < 3; ++axis) {
                glm::dvec3 next = at;
                next[axis] += step;
                if ((polynomial.value(next) < 0.0) != inside) {
                    box = joined(box, {at - step, next + step});
                }
            }
        }
    }
    const glm::dvec3 reach = glm::max(-box.low, box.high);
    if (!box.empty() && std::max({reach.x, reach.y, reach.z}) < half_last) {
        return {box, true};
    }
    return {};
}

PovCubes cube_around(const Box3& box) {
    const glm::dvec3 lengths = box.high - box.low;
    const double longest = std::max({lengths.x, lengths.y, lengths.z});
    const double shortest = std::min({lengths.x, lengths.y, lengths.z});
    return {{0.5 * (box.low + box.high)}, 0.5 * longest, shortest > (1.0 - rounding) * longest};
}

// Along each axis the last cube overlaps the one before it, so that none stands out of the box.
PovCubes cubes_of(const Box3& box) {
    const glm::dvec3 lengths = box.high - box.low;
    const double edge = std::min({lengths.x, lengths.y, lengths.z});
    const glm::dvec3 counts = glm::max(glm::ceil(lengths / edge - 1e-6), glm::dvec3(1.0));
    if (!(edge > 0.0) || !(counts.x * counts.y * counts.z <= cubes_max)) {
        return cube_around(box);
    }
    PovCubes cubes;
    cubes.half_size = 0.5 * edge;
    const glm::ivec3 n(counts);
    for (int i = 0; i < n.x * n.y * n.z; ++i) {
        const glm::dvec3 low = box.low + edge * glm::dvec3(i % n.x, i / n.x % n.y, i / n.x / n.y);
        cubes.centres.push_back(glm::min(low, box.high - edge) + 0.5 * edge);
    }
    return cubes;
}

}  // namespace quartic
