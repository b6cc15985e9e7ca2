// What makes a plant believable: joints that meet, the mixture of kinds, names like those of
// plants.
#include "generators/generate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

namespace quartic {
namespace {

struct PlacedEnd {
    glm::dvec3 centre;
    glm::dvec3 normal;
    double radius;
    std::uint32_t part;
};

std::vector<PlacedEnd> ends_of(const Scene& scene, std::uint32_t index) {
    const Part& part = scene.parts[index];
    std::vector<PlacedEnd> ends;
    visit_shape(scene.shapes, part.type, part.shape, [&](const auto& shape) {
        for (int i = 0; i < f64().end_count(shape); ++i) {
            const f64::End end = f64().end(shape, i);
            ends.push_back({part.placement.position + part.placement.rotation * end.centre,
                            part.placement.rotation * end.normal, end.radius, index});
        }
    });
    return ends;
}

bool meet(const PlacedEnd& a, const PlacedEnd& b) {
    return glm::length(a.centre - b.centre) < 1e-6 && glm::dot(a.normal, b.normal) < -1.0 + 1e-9;
}

Scene make(std::string_view kind) {
    return generate(kind, {}).value();
}

TEST(Run, all_joints_coincide) {
    const Scene scene = make("run");
    std::vector<PlacedEnd> ends;
    for (std::uint32_t i = 0; i < scene.parts.size(); ++i) {
        const std::vector<PlacedEnd> own = ends_of(scene, i);
        ends.insert(ends.end(), own.begin(), own.end());
    }
    ASSERT_EQ(ends.size(), 9u);  // the cap has one end, and the run is open at its start
    int joined = 0;
    for (const PlacedEnd& a : ends) {
        joined += static_cast<int>(std::any_of(ends.begin(), ends.end(), [&](const PlacedEnd& b) {
            return a.part != b.part && meet(a, b) && std::abs(a.radius - b.radius) < 1e-9;
        }));
    }
    EXPECT_EQ(joined, 8);
}

// Sorts ends into cells, so that neighbours are found without comparing all.
class Cells {
public:
    explicit Cells(const std::vector<PlacedEnd>& ends) {
        for (const PlacedEnd& end : ends) {
            cells_[cell(end.centre)].push_back(&end);
        }
    }
    bool is_joined(const PlacedEnd& end) const {
        for (int i = 0; i < 8; ++i) {  // an end near a border may have its neighbour across it
            const glm::dvec3 shift(i & 1 ? 1e-6 : -1e-6, i & 2 ? 1e-6 : -1e-6,
                                   i & 4 ? 1e-6 : -1e-6);
            const auto found = cells_.find(cell(end.centre + shift));
            if (found == cells_.end()) {
                continue;
            }
            for (const PlacedEnd* other : found->second) {
                if (other->part != end.part && meet(*other, end)) {
                    return true;
                }
            }
        }
        return false;
    }

private:
    using Cell = std::array<long, 3>;
    static Cell cell(const glm::dvec3& p) {
        return {std::lround(p.x * 1e3), std::lround(p.y * 1e3), std::lround(p.z * 1e3)};
    }
    std::map<Cell, std::vector<const PlacedEnd*>> cells_;
};

TEST(Plant, elbows_are_joined_at_both_ends) {
    const Scene scene = make("plant");
    std::vector<PlacedEnd> ends;
    for (std::uint32_t i = 0; i < scene.parts.size(); ++i) {
        const std::vector<PlacedEnd> own = ends_of(scene, i);
        ends.insert(ends.end(), own.begin(), own.end());
    }
    const Cells cells(ends);
    int elbows = 0;
    int loose = 0;
    for (std::uint32_t i = 0; i < scene.parts.size(); ++i) {
        const std::string_view name = scene.strings[scene.nodes[scene.parts[i].node].name];
        if (scene.parts[i].type != ShapeType::torus || !name.starts_with("ELBOW")) {
            continue;
        }
        ++elbows;
        for (const PlacedEnd& end : ends_of(scene, i)) {
            loose += static_cast<int>(!cells.is_joined(end));
        }
    }
    EXPECT_GT(elbows, 200);
    EXPECT_EQ(loose, 0);
}

TEST(Plant, more_than_half_of_the_pipe_ends_meet_another_part) {
    const Scene scene = make("plant");
    std::vector<PlacedEnd> ends;
    for (std::uint32_t i = 0; i < scene.parts.size(); ++i) {
        if (scene.strings[scene.nodes[scene.parts[i].node].name].starts_with("TUBE")) {
            const std::vector<PlacedEnd> own = ends_of(scene, i);
            ends.insert(ends.end(), own.begin(), own.end());
        }
    }
    const std::size_t tubes = ends.size();
    for (std::uint32_t i = 0; i < scene.parts.size(); ++i) {
        if (!scene.strings[scene.nodes[scene.parts[i].node].name].starts_with("TUBE")) {
            const std::vector<PlacedEnd> own = ends_of(scene, i);
            ends.insert(ends.end(), own.begin(), own.end());
        }
    }
    const Cells cells(ends);
    std::size_t joined = 0;
    for (std::size_t i = 0; i < tubes; ++i) {
        joined += cells.is_joined(ends[i]) ? 1u : 0u;
    }
    EXPECT_GT(double(joined) / double(tubes), 0.5);
}

TEST(Plant, has_all_that_plants_have) {
    const Scene scene = make("plant");
    std::map<ShapeType, std::size_t> counts;
    std::set<double> arcs_deg;
    for (const Part& part : scene.parts) {
        ++counts[part.type];
    }
    for (const f64::Torus& torus : scene.shapes.torus) {
        arcs_deg.insert(std::round(torus.arc * 57.295779513082323));
        EXPECT_GE(torus.bend_radius, torus.radius);
    }
    for (const ShapeType type :
         {ShapeType::cylinder, ShapeType::box, ShapeType::torus, ShapeType::cone, ShapeType::snout,
          ShapeType::dish, ShapeType::pyramid, ShapeType::sphere, ShapeType::disk,
          ShapeType::rectangular_torus}) {
        EXPECT_GT(counts[type], 5u) << name(type);
    }
    EXPECT_GT(double(counts[ShapeType::cylinder]) / double(scene.parts.size()), 0.3);
    for (const double arc : {30.0, 45.0, 60.0, 90.0, 180.0, 360.0}) {
        EXPECT_TRUE(arcs_deg.contains(arc)) << arc;
    }
}

TEST(Plant, some_lines_are_insulated_in_a_layer_and_a_translucent_material) {
    const Scene scene = make("plant");
    std::size_t insulated = 0;
    for (const Part& part : scene.parts) {
        const bool translucent = scene.materials[part.material].colour.a < 1.0f;
        EXPECT_EQ(translucent, part.layer == Layer::insulation);
        insulated += translucent ? 1u : 0u;
    }
    EXPECT_GT(insulated, 50u);
}

TEST(Plant, most_nodes_have_one_material) {
    const Scene scene = make("plant");
    std::map<std::uint32_t, std::set<std::uint32_t>> materials;
    for (const Part& part : scene.parts) {
        materials[part.node].insert(part.material);
    }
    const auto mixed = std::count_if(materials.begin(), materials.end(),
                                     [](const auto& entry) { return entry.second.size() > 1; });
    EXPECT_LT(double(mixed), 0.1 * double(materials.size()));
}

TEST(Plant, names_are_paths_like_those_of_plants) {
    const Scene scene = make("plant");
    bool found = false;
    for (std::uint32_t i = 0; i < scene.nodes.size() && !found; ++i) {
        const std::string path = path_of(scene, i);
        found = path.starts_with("/SITE-1/AREA-1/UNIT-1/PIPE-") &&
                path.find("/B1/ELBOW 1") != std::string::npos;
    }
    EXPECT_TRUE(found);
    EXPECT_GT(scene.attributes.size(), 100u);
}

TEST(Plant, a_bigger_plant_begins_with_the_same_unit) {
    GenerateOptions options;
    options.count = 8000;
    const Scene small = generate("plant", options).value();
    options.count = 9000;
    const Scene large = generate("plant", options).value();
    for (std::size_t i = 0; i < 1000; ++i) {
        ASSERT_EQ(small.parts[i].placement.position, large.parts[i].placement.position);
    }
}

}  // namespace
}  // namespace quartic
