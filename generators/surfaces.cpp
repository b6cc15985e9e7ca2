// The gallery of algebraic surfaces, set up in rows on a floor.
#include "generators/gallery.h"
#include "generators/kinds.h"
#include "generators/random.h"
#include "scene/algebraic_surface.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

namespace quartic {
namespace {

constexpr double gap = 0.5;  // between cubes, of their edge

// Hues by the golden ratio, which keeps neighbours apart.
glm::vec4 colour_of(std::size_t index) {
    const double hue = std::fmod(0.08 + 0.6180339887 * static_cast<double>(index), 1.0);
    const auto channel = [&](double shift) {
        const double wave = std::abs(std::fmod(6.0 * hue + shift, 6.0) - 3.0) - 1.0;
        return static_cast<float>(0.06 + 0.62 * std::clamp(wave, 0.0, 1.0));
    };
    return {channel(0.0), channel(4.0), channel(2.0), 1.0f};
}

glm::dquat turned(std::uint64_t seed, std::uint64_t index) {
    Random random(seed, index);
    glm::dquat rotation;
    do {
        rotation = {random.between(-1.0, 1.0), random.between(-1.0, 1.0), random.between(-1.0, 1.0),
                    random.between(-1.0, 1.0)};
    } while (glm::length(rotation) > 1.0 || glm::length(rotation) < 0.1);
    return glm::normalize(rotation);
}

std::string text_of(const glm::dvec3& v) {
    std::array<char, 96> text{};
    std::snprintf(text.data(), text.size(), "%.6g, %.6g, %.6g", v.x, v.y, v.z);
    return text.data();
}

std::uint32_t add_node(Scene& scene, std::string_view name, std::uint32_t parent,
                       const glm::dvec3& position) {
    Node node;
    node.name = scene.strings.add(name);
    node.parent = parent;
    node.position = position;
    node.first_attribute = static_cast<std::uint32_t>(scene.attributes.size());
    scene.nodes.push_back(node);
    return static_cast<std::uint32_t>(scene.nodes.size() - 1);
}

void add_attribute(Scene& scene, std::string_view key, std::string_view value) {
    scene.attributes.push_back({scene.strings.add(key), scene.strings.add(value)});
    ++scene.nodes.back().attribute_count;
}

void describe(Scene& scene, const GallerySurface& surface) {
    add_attribute(scene, "equation", surface.original.text() + " = 0");
    add_attribute(scene, "degree", std::to_string(surface.degree));
    add_attribute(scene, "source", surface.source);
    for (const glm::dvec3& point : surface.singular_points) {
        add_attribute(scene, "singular point, cube from -1 to 1", text_of(point));
    }
}

}  // namespace

// The cube of each surface stands on the floor at z = 0. Beyond the gallery's end it begins again,
// with its surfaces turned at random.
Scene make_surfaces(const GenerateOptions& options) {
    Scene scene;
    scene.kinds = {"cubic", "quartic"};
    scene.kind_counts = {0, 0};
    for (std::size_t i = 0; i < gallery().size(); ++i) {
        scene.materials.push_back({std::string(gallery()[i].name), colour_of(i), 0});
    }
    const auto count = static_cast<double>(options.count);
    const double side = std::ceil(std::sqrt(count));
    const double pitch = options.extent_m > 0.0 ? options.extent_m / side : 2.0 * (1.0 + gap);
    const double half_size = 0.5 * pitch / (1.0 + gap);
    const std::uint32_t root = add_node(scene, "SURFACES", no_index, glm::dvec3(0.0));
    for (std::uint64_t i = 0; i < options.count; ++i) {
        const std::size_t index = i % gallery().size();
        const GallerySurface& surface = gallery()[index];
        const auto row = static_cast<std::uint64_t>(side);
        const glm::dvec3 centre(pitch * (static_cast<double>(i % row) + 0.5),
                                -pitch * (static_cast<double>(i / row) + 0.5), half_size);
        const std::uint64_t round = i / gallery().size();
        const std::string name =
            std::string(surface.name) + (round > 0 ? " " + std::to_string(round + 1) : "");
        Part part;
        part.node = add_node(scene, name, root, centre);
        describe(scene, surface);
        part.material = static_cast<std::uint32_t>(index);
        part.kind = surface.degree == 3 ? 0 : 1;
        part.placement.position = centre;
        if (round > 0) {
            part.placement.rotation = turned(options.seed, i);
        }
        const Added added = add_surface(scene, surface.polynomial, half_size, part);
        CHECK(added.drawn);
        ++scene.kind_counts[part.kind];
    }
    for (std::size_t kind = 0; kind < scene.kinds.size(); ++kind) {
        if (scene.kind_counts[kind] > 0) {
            scene.outcomes.push_back({scene.kinds[kind], "analytic", "", scene.kind_counts[kind]});
        }
    }
    return scene;
}

}  // namespace quartic
