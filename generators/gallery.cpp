// The formulas of famous surfaces, as their sources give them.
#include "generators/gallery.h"

#include <cmath>
#include <initializer_list>

namespace quartic {
namespace {

const Polynomial3 x = Polynomial3::x();
const Polynomial3 y = Polynomial3::y();
const Polynomial3 z = Polynomial3::z();

Polynomial3 square(const Polynomial3& p) {
    return power(p, 2);
}

Polynomial3 cube(const Polynomial3& p) {
    return power(p, 3);
}

// The part of a source's space that becomes the cube: its middle, and half its width.
struct Frame {
    glm::dvec3 middle{0.0};
    double half = 1.0;
    glm::dmat3 axes{1.0};  // of the cube, in the source's coordinates
};

GallerySurface surface(std::string_view name, std::string_view source, const Polynomial3& formula,
                       const Frame& frame, std::vector<glm::dvec3> singular_points) {
    const glm::dmat3 axes = frame.half * frame.axes;
    GallerySurface result;
    result.name = name;
    result.degree = formula.degree();
    result.source = source;
    result.original = formula;
    result.polynomial = formula.of(glm::dmat4x3(axes[0], axes[1], axes[2], frame.middle));
    for (glm::dvec3& point : singular_points) {
        point = glm::transpose(frame.axes) * (point - frame.middle) / frame.half;
    }
    result.singular_points = std::move(singular_points);
    return result;
}

// Four nodes, the most that a cubic can have.
GallerySurface cayley() {
    const double h = 0.5;
    return surface("Cayley cubic", "A. Cayley 1869; mathworld.wolfram.com/CayleyCubic.html",
                   4 * (square(x) + square(y) + square(z)) + 16 * x * y * z - 1, {{}, 0.9},
                   {{-h, -h, -h}, {-h, h, h}, {h, -h, h}, {h, h, -h}});
}

// Smooth; all of its 27 lines are real. Its threefold axis stands upright in the cube.
GallerySurface clebsch() {
    const Polynomial3 mixed = square(x) * y + square(x) * z + square(y) * x + square(y) * z +
                              square(z) * x + square(z) * y;
    const Polynomial3 formula = 81 * (cube(x) + cube(y) + cube(z)) - 189 * mixed + 54 * x * y * z +
                                126 * (x * y + x * z + y * z) -
                                9 * (square(x) + square(y) + square(z)) - 9 * (x + y + z) + 1;
    const glm::dvec3 up = glm::normalize(glm::dvec3(1.0));
    const glm::dvec3 side = glm::normalize(glm::dvec3(1.0, -1.0, 0.0));
    return surface("Clebsch diagonal cubic",
                   "A. Clebsch 1871; mathworld.wolfram.com/ClebschDiagonalCubic.html", formula,
                   {{}, 1.3, {side, glm::cross(up, side), up}}, {});
}

GallerySurface ding_dong() {
    return surface("ding-dong", "H. Hauser, gallery of algebraic surfaces",
                   square(x) + square(y) - (1 - z) * square(z), {{}, 1.05}, {{0, 0, 0}});
}

// Every band that is bent as Moebius's, with straight rulings, lies on this ruled surface; two of
// the rulings meet in each point of a double line.
GallerySurface moebius() {
    return surface("Moebius cubic", "mathworld.wolfram.com/MoebiusStrip.html, R = 1",
                   square(x) * y + cube(y) - y - 2 * x * z - 2 * square(x) * z - 2 * square(y) * z +
                       y * square(z),
                   {{}, 1.6}, {{-1, 0, 0}, {-1, 0.8, 0.8}, {-1, -0.8, -0.8}});
}

GallerySurface whitney() {
    return surface("Whitney umbrella",
                   "H. Whitney 1943; mathworld.wolfram.com/WhitneyUmbrella.html",
                   square(x) - square(y) * z, {}, {{0, 0, 0}, {0, 0, 0.5}, {0, 0, -0.5}});
}

GallerySurface monkey_saddle() {
    return surface("monkey saddle", "mathworld.wolfram.com/MonkeySaddle.html",
                   cube(x) - 3 * x * square(y) - z, {}, {});
}

// Three double lines that meet in a triple point and end in six pinch points.
GallerySurface roman() {
    std::vector<glm::dvec3> points{{0, 0, 0}};
    for (int axis = 0; axis < 3; ++axis) {
        for (const double place : {-0.5, -0.25, 0.25, 0.5}) {
            points.emplace_back(0.0);
            points.back()[axis] = place;
        }
    }
    return surface(
        "Roman surface", "J. Steiner 1844; mathworld.wolfram.com/RomanSurface.html",
        square(x) * square(y) + square(y) * square(z) + square(z) * square(x) - x * y * z,
        {{}, 0.53}, points);
}

// Sixteen nodes, the most that a quartic can have. Twelve lie where the edges of the tetrahedron of
// p, q, r, s meet the sphere of radius mu, four on the axes of the tetrahedron.
GallerySurface kummer() {
    constexpr double mu_squared = 1.69;
    const double lambda = (3 * mu_squared - 1) / (3 - mu_squared);
    const double root = std::sqrt(2.0);
    const Polynomial3 formula = square(square(x) + square(y) + square(z) - mu_squared) -
                                lambda * ((1 - z - root * x) * (1 - z + root * x) *
                                          (1 + z + root * y) * (1 + z - root * y));
    std::vector<glm::dvec3> nodes;
    const double reach = std::sqrt(mu_squared - 1.0);
    const double on_axis = 0.5 * (mu_squared - 1.0);
    for (const double a : {-1.0, 1.0}) {
        nodes.emplace_back(0, a * reach, 1);
        nodes.emplace_back(a * reach, 0, -1);
        nodes.push_back(on_axis * glm::dvec3(0, a * root, 1));
        nodes.push_back(on_axis * glm::dvec3(a * root, 0, -1));
        for (const double b : {-1.0, 1.0}) {
            const glm::dvec3 middle = std::sqrt(0.5) * glm::dvec3(b, a, 0);
            const glm::dvec3 along = glm::normalize(glm::dvec3(-b * root, a * root, 2));
            nodes.push_back(middle - reach * along);
            nodes.push_back(middle + reach * along);
        }
    }
    return surface("Kummer surface",
                   "E. Kummer 1864; mathworld.wolfram.com/KummerSurface.html, mu^2 = 1.69", formula,
                   {{}, 1.9}, nodes);
}

// A smooth skin; the origin is a point of the zero set by itself.
GallerySurface tooth() {
    return surface("tooth", "mathworld.wolfram.com/ToothSurface.html",
                   power(x, 4) + power(y, 4) + power(z, 4) - square(x) - square(y) - square(z),
                   {{}, 1.25}, {{0, 0, 0}});
}

// Twelve nodes.
GallerySurface chubs() {
    const double h = std::sqrt(0.5);
    std::vector<glm::dvec3> nodes;
    for (const double a : {-h, h}) {
        for (const double b : {-h, h}) {
            nodes.insert(nodes.end(), {{a, b, 0}, {a, 0, b}, {0, a, b}});
        }
    }
    return surface(
        "chubs", "mathworld.wolfram.com/Chubs.html",
        power(x, 4) + power(y, 4) + power(z, 4) - square(x) - square(y) - square(z) + 0.5,
        {{}, 1.06}, nodes);
}

GallerySurface cushion() {
    return surface("cushion", "mathworld.wolfram.com/CushionSurface.html",
                   square(z) * square(x) - power(z, 4) - 2 * z * square(x) + 2 * cube(z) +
                       square(x) - square(z) - square(square(x) - z) - power(y, 4) -
                       2 * square(x) * square(y) - square(y) * square(z) + 2 * square(y) * z +
                       square(y),
                   {{0, 0, 0.33}, 1.32}, {{0, 0, 0}, {1, 0, 1}, {-1, 0, 1}});
}

// A double line from one pinch point to another; beyond them the line belongs to the zero set, but
// no sheet passes through it.
GallerySurface cross_cap() {
    return surface("cross-cap", "mathworld.wolfram.com/Cross-Cap.html",
                   4 * square(x) * (square(x) + square(y) + square(z) + z) +
                       square(y) * (square(y) + square(z) - 1),
                   {{}, 1.06}, {{0, 0, 0}, {0, 0, 0.5}, {0, 0, 1}, {0, 0, -1}});
}

// A cusp.
GallerySurface piriform() {
    return surface("piriform", "mathworld.wolfram.com/PiriformSurface.html",
                   power(x, 4) - cube(x) + square(y) + square(z), {{0.5, 0, 0}, 0.53}, {{0, 0, 0}});
}

// A ring whose tube is thick on one side: a = 1, c = 0.4, d = 0.55 and b^2 = a^2 - c^2.
GallerySurface dupin_cyclide() {
    constexpr double c = 0.4;
    constexpr double d = 0.55;
    constexpr double b_squared = 1.0 - c * c;
    return surface("Dupin cyclide", "C. Dupin 1822; mathworld.wolfram.com/Cyclide.html",
                   square(square(x) + square(y) + square(z) + (b_squared - d * d)) -
                       4 * square(x - c * d) - 4 * b_squared * square(y),
                   {{-c, 0, 0}, 1.6}, {});
}

// A double line between two pinch points.
GallerySurface miter() {
    return surface("miter", "mathworld.wolfram.com/MiterSurface.html",
                   4 * square(x) * (square(x) + square(y) + square(z)) -
                       square(y) * (1 - square(y) - square(z)),
                   {{}, 1.06}, {{0, 0, 0}, {0, 0, 0.5}, {0, 0, -0.5}, {0, 0, 1}, {0, 0, -1}});
}

GallerySurface torus() {
    constexpr double bend_radius = 0.7;
    constexpr double radius = 0.3;
    return surface(
        "torus", "mathworld.wolfram.com/Torus.html, R = 0.7, r = 0.3",
        square(square(x) + square(y) + square(z) + (bend_radius * bend_radius - radius * radius)) -
            4 * bend_radius * bend_radius * (square(x) + square(y)),
        {}, {});
}

}  // namespace

std::span<const GallerySurface> gallery() {
    static const std::vector<GallerySurface> all{
        cayley(),   clebsch(),       ding_dong(), moebius(), whitney(), monkey_saddle(),
        roman(),    kummer(),        tooth(),     chubs(),   cushion(), cross_cap(),
        piriform(), dupin_cyclide(), miter(),     torus()};
    return all;
}

const GallerySurface* find_in_gallery(std::string_view name) {
    for (const GallerySurface& surface : gallery()) {
        if (surface.name == name) {
            return &surface;
        }
    }
    return nullptr;
}

}  // namespace quartic
