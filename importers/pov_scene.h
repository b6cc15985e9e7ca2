// Objects of POV-Ray's scene language as parts of a scene.
#pragma once

#include "importers/pov_domain.h"
#include "importers/pov_reader.h"
#include "scene/add_shape.h"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace quartic {

// At most so many objects are visited: the rest, which only shared branches can make so many, is
// lost.
class PovSceneBuilder {
public:
    PovSceneBuilder(Scene& scene, std::uint64_t visits_max)
        : scene_(scene), visits_left_(visits_max) {}

    void add(const PovPlaced& object);
    void finish();  // kinds and outcomes

private:
    // What an object takes over from those around it; matrices lead into POV-Ray's world.
    struct Around {
        glm::dmat4 matrix{1.0};
        std::optional<PovValue> colour;
        std::string name;
        std::vector<PovPlaced> clips;
        std::vector<PovPlaced> bounds;
    };

    void visit(const PovObject& object, const Around& around);
    void visit_children(const PovObject& object, const Around& here);
    void intersection(const PovObject& object, const Around& here);
    bool torus_arc(const PovObject& object, const Around& here);
    void draw(const PovObject& object, const Around& here);
    void algebraic(const PovObject& object, const Around& here);
    PovDomain surface_domain(const PovObject& object, const Around& here, bool& exact);
    PovExtent extent_for(const Polynomial3& polynomial);
    void surface(const PovObject& object, const Around& here, const PovDomain& domain,
                 const PovCubes& cubes);
    Added place_round(const PovObject& object, const glm::dmat4& map, Part& part);
    Added place_box(const PovObject& object, const glm::dmat4& map, Part& part);
    Added place_torus(const PovObject& object, const glm::dmat4& map, Part& part);
    Added place_sphere(const PovObject& object, const glm::dmat4& map, Part& part);
    void warped(const PovObject& object, const Around& here);
    void mesh(const PovObject& object, const Around& here);

    Part part_of(const PovObject& object, const Around& here);
    std::uint32_t material_of(const std::optional<PovValue>& colour);
    void tally(const PovObject& object, std::string_view became, std::string_view reason,
               Severity severity);

    struct Count {
        std::string_view kind;
        std::string_view became;
        std::string_view reason;
        std::uint64_t count;
    };

    Scene& scene_;
    std::uint64_t visits_left_;
    std::map<std::array<double, Polynomial3::term_count>, PovExtent> extents_;
    std::map<std::array<float, 4>, std::uint32_t> materials_;
    std::vector<Count> counts_;
};

}  // namespace quartic
