// What several verbs read from the command line: reporting, sizes, vectors, layers, cameras.
#pragma once

#include "cli/report.h"
#include "scene/camera.h"

#include <CLI/CLI.hpp>

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace quartic::cli {

// --json, --verbose, --quiet, --strict, --progress, --time-limit.
void add_reporting(CLI::App& verb, Reporting& reporting);

// "1600x1000"; from 1 to 16,384 each.
std::optional<PixelSize> find_size(std::string_view text);
// "1,-2.5,3e2"
std::optional<glm::dvec3> find_vector(std::string_view text);

// For CLI11: the complaint about an argument, or empty.
std::string check_size(const std::string& text);
std::string check_vector(const std::string& text);
std::string check_solver(const std::string& text);
std::string check_layer(const std::string& text);

// The number of a solver that check_solver let pass; 0, the materials' own, for an empty name.
int solver_number(const std::string& name);

// Names as --show and --hide have them.
std::array<bool, layer_count> chosen_layers(const std::vector<std::string>& shown,
                                            const std::vector<std::string>& hidden);

// CLI11 would report what follows a mistyped option, since that becomes a file's name. So options
// are looked at first, and verbs with them: the complaint about the first unknown one, or empty.
std::string find_unknown_word(const CLI::App& program, int count, const char* const* arguments);

}  // namespace quartic::cli
