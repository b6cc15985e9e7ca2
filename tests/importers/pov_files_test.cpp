// POV-Ray's own example scenes of quartics: every surface, in its place.
#include "importers/load.h"
#include "scene/algebraic_surface.h"
#include "tests/importers/model_files.h"

#include <gtest/gtest.h>

namespace quartic {
namespace {

struct Expected {
    const char* name;
    std::size_t cubics;  // a quartic statement may hold a cubic
    std::size_t quartics;
    std::size_t cylinders;
};

constexpr Expected files[] = {{"folium", 1, 0, 0},  {"helix", 0, 81, 0},   {"lemnisc2", 0, 2, 0},
                              {"monkey", 1, 0, 0},  {"piriform", 0, 1, 0}, {"quarpara", 0, 1, 0},
                              {"steiner", 0, 1, 3}, {"teardrop", 0, 1, 0}, {"trough", 0, 1, 0}};

Scene load(const std::string& path) {
    Progress progress;
    Result<Scene> scene = load_scene(path, ImportOptions{}, progress);
    EXPECT_TRUE(scene.ok()) << (scene ? "" : scene.error().message);
    return scene ? std::move(scene).value() : Scene();
}

TEST(PovFiles, every_example_gives_its_surfaces_and_loses_nothing) {
    for (const Expected& file : files) {
        SCOPED_TRACE(file.name);
        const std::string path = test_data(std::string("quartics/povray/") + file.name + ".pov");
        SKIP_WITHOUT(path);
        const Scene scene = load(path);
        EXPECT_EQ(scene.shapes.cubic.size(), file.cubics);
        EXPECT_EQ(scene.shapes.quartic.size(), file.quartics);
        EXPECT_EQ(scene.shapes.cylinder.size(), file.cylinders);
        EXPECT_EQ(scene.findings.count(Severity::loss), 0u);
        EXPECT_EQ(scene.findings.count(Severity::warning), 0u);
    }
}

// monkey.pov: z = x^3 - 3 x y^2 in a cube of half size 2, turned by 20 degrees about y, then by -30
// about x.
TEST(PovFiles, the_monkey_saddle_stands_where_pov_ray_shows_it) {
    const std::string path = test_data("quartics/povray/monkey.pov");
    SKIP_WITHOUT(path);
    const Scene scene = load(path);
    ASSERT_EQ(scene.parts.size(), 1u);
    EXPECT_EQ(scene.materials[scene.parts[0].material].colour, glm::vec4(1, 0, 0, 1));
    const f64::CubicSurface& surface = scene.shapes.cubic[0];
    EXPECT_NEAR(surface.half_size, 2.0, 1e-12);
    const Placement& placement = scene.parts[0].placement;
    for (const glm::dvec2& at : {glm::dvec2(0.3, 0.4), glm::dvec2(-1.0, 0.5)}) {
        const glm::dvec3 p(at, at.x * at.x * at.x - 3.0 * at.x * at.y * at.y);
        const double c20 = std::cos(glm::radians(20.0));
        const double s20 = std::sin(glm::radians(20.0));
        const double c30 = std::cos(glm::radians(-30.0));
        const double s30 = std::sin(glm::radians(-30.0));
        const glm::dvec3 q(c20 * p.x + s20 * p.z, p.y, -s20 * p.x + c20 * p.z);
        const glm::dvec3 pov(q.x, c30 * q.y - s30 * q.z, s30 * q.y + c30 * q.z);
        const glm::dvec3 world(pov.x, pov.z, pov.y);
        const glm::dvec3 local = glm::conjugate(placement.rotation) * (world - placement.position);
        EXPECT_NEAR(f64().value(surface, local), 0.0, 1e-12);
        EXPECT_GT(glm::length(f64().gradient(surface, local)), 0.1);
    }
}

}  // namespace
}  // namespace quartic
