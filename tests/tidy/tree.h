// The project's own files as a value, so that rules can be tested on trees that do not exist.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace quartic::tidy {

// Texts by path from the root, with forward slashes; bytes that are no text are there as "".
using Tree = std::map<std::string, std::string>;

// Everything below the root but build folders, git's own, and models beside the tree.
Tree read_tree(const std::filesystem::path& root);

std::string_view folder_of(std::string_view path);  // "tests/gpu" of "tests/gpu/layout_test.cpp"
std::string_view top_folder_of(std::string_view path);  // "tests"; "" for a file in the root
std::string_view name_of(std::string_view path);        // "layout_test.cpp"
std::string_view stem_of(std::string_view path);        // "layout_test"
std::string_view extension_of(std::string_view path);   // ".cpp"; "" where there is none

bool is_header(std::string_view path);
bool is_source(std::string_view path);
bool is_shader(std::string_view path);  // GLSL, shared or not
bool is_code(std::string_view path);    // any of the three
bool is_cmake(std::string_view path);
bool is_script(std::string_view path);  // bash, by its place: ./dev and .ci/run, or *.sh

std::vector<std::string_view> lines_of(std::string_view text);

}  // namespace quartic::tidy
