// Models with known truth, made from a seed.
#pragma once

#include "diagnostics/result.h"
#include "scene/scene.h"

#include <cstdint>
#include <span>
#include <string_view>

namespace quartic {

struct GenerateOptions {
    std::uint64_t count = 0;  // about so many parts; 0: as many as the kind has by itself
    std::uint64_t seed = 1;
    double extent_m = 0.0;   // side length of the site or cube; 0: as the count needs
    glm::dvec3 offset{0.0};  // moves everything
};

struct GeneratorRow {
    std::string_view name;
    std::string_view what;
    std::uint64_t count_default;  // 0: the count cannot be chosen
    Scene (*make)(const GenerateOptions& options);
};

std::span<const GeneratorRow> generator_table();

// The same kind and options give the same scene, on any machine.
Result<Scene> generate(std::string_view kind, const GenerateOptions& options);

}  // namespace quartic
