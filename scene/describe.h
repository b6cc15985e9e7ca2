// What a part is, in the words and units of an engineer: millimetres and degrees.
#pragma once

#include "scene/scene.h"

#include <string>
#include <string_view>
#include <vector>

namespace quartic {

struct Property {
    std::string label;  // "Bend radius"
    std::string text;   // "228.6 mm"
};

// The parameters of the part's shape, or what is to be said of its mesh.
std::vector<Property> describe_shape(const Scene& scene, const Part& part);

// Path, name, kind, shape and its parameters, material, layer and position.
std::vector<Property> describe(const Scene& scene, std::uint32_t part);

// "rectangular torus"
std::string spoken(std::string_view name);
std::string_view name(Layer layer);

// "168.3 mm": at most a micrometre's digits, no zeros at the end; the same in every locale.
std::string length_text(double metres);
std::string angle_text(double radians);
std::string position_text(const glm::dvec3& metres);

}  // namespace quartic
