// The gallery's formulas: degrees, singular points, and that there is something to see.
#include "generators/gallery.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace quartic {
namespace {

TEST(Gallery, names_are_unique_and_found) {
    std::set<std::string_view> names;
    for (const GallerySurface& surface : gallery()) {
        names.insert(surface.name);
        EXPECT_EQ(find_in_gallery(surface.name), &surface);
        EXPECT_FALSE(surface.source.empty());
    }
    EXPECT_EQ(names.size(), gallery().size());
    EXPECT_EQ(gallery().size(), 16u);
    EXPECT_EQ(find_in_gallery("sphere"), nullptr);
}

TEST(Gallery, cubics_come_first_and_degrees_are_as_said) {
    int cubics = 0;
    for (const GallerySurface& surface : gallery()) {
        EXPECT_EQ(surface.polynomial.degree(), surface.degree) << surface.name;
        EXPECT_EQ(surface.original.degree(), surface.degree) << surface.name;
        EXPECT_EQ(surface.degree, cubics == 6 ? 4 : 3) << surface.name;
        cubics += surface.degree == 3;
    }
    EXPECT_EQ(cubics, 6);
}

TEST(Gallery, value_and_gradient_vanish_in_singular_points) {
    std::size_t count = 0;
    for (const GallerySurface& surface : gallery()) {
        const double size = surface.polynomial.largest_term();
        for (const glm::dvec3& point : surface.singular_points) {
            SCOPED_TRACE(surface.name);
            EXPECT_LE(std::abs(surface.polynomial.value(point)), 1e-13 * size);
            EXPECT_LE(glm::length(surface.polynomial.gradient(point)), 1e-13 * size);
            EXPECT_LE(glm::length(point), std::sqrt(3.0));
            ++count;
        }
    }
    EXPECT_EQ(find_in_gallery("Cayley cubic")->singular_points.size(), 4u);
    EXPECT_EQ(find_in_gallery("Kummer surface")->singular_points.size(), 16u);
    EXPECT_EQ(find_in_gallery("chubs")->singular_points.size(), 12u);
    EXPECT_GT(count, 50u);
}

TEST(Gallery, the_torus_is_that_of_its_radii) {
    const GallerySurface& torus = *find_in_gallery("torus");
    for (int i = 0; i < 24; ++i) {
        for (int k = 0; k < 24; ++k) {
            const double u = 0.3 * i;
            const double v = 0.3 * k;
            const double rho = 0.7 + 0.3 * std::cos(v);
            const glm::dvec3 point(rho * std::cos(u), rho * std::sin(u), 0.3 * std::sin(v));
            EXPECT_NEAR(torus.polynomial.value(point), 0.0, 1e-14);
        }
    }
}

// Sign changes between neighbours on lines along z.
int count_crossings(const Polynomial3& polynomial) {
    constexpr int lines = 40;
    constexpr int steps = 160;
    int crossings = 0;
    for (int i = 0; i < lines * lines; ++i) {
        const double x = -1.0 + 2.0 * (i % lines + 0.513) / lines;
        const double y = -1.0 + 2.0 * (i / lines + 0.487) / lines;
        double before = polynomial.value({x, y, -1.0});
        for (int k = 1; k <= steps; ++k) {
            const double value = polynomial.value({x, y, -1.0 + 2.0 * k / steps});
            crossings += (before < 0.0) != (value < 0.0);
            before = value;
        }
    }
    return crossings;
}

TEST(Gallery, every_surface_has_much_to_see_in_the_cube) {
    for (const GallerySurface& surface : gallery()) {
        EXPECT_GT(count_crossings(surface.polynomial), 300) << surface.name;
    }
}

}  // namespace
}  // namespace quartic
