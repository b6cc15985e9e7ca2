// Reads the tree and takes paths apart.
#include "tests/tidy/tree.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>

namespace quartic::tidy {
namespace {

namespace fs = std::filesystem;

template <std::size_t count>
bool is_one_of(std::string_view word, const std::array<std::string_view, count>& words) {
    return std::find(words.begin(), words.end(), word) != words.end();
}

bool is_foreign_folder(const std::string& name) {
    return name == ".git" || name == "build" || name.starts_with("build-") || name == "shared" ||
           name == "node_modules" || name == "__pycache__";
}

std::string read_text(const fs::path& path) {
    std::ifstream stream(path, std::ios::binary);
    std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
    return text.find('\0') == std::string::npos ? text : std::string();
}

}  // namespace

Tree read_tree(const fs::path& root) {
    Tree tree;
    auto at = fs::recursive_directory_iterator(root);
    for (; at != fs::recursive_directory_iterator(); ++at) {
        if (at->is_directory() && is_foreign_folder(at->path().filename().string())) {
            at.disable_recursion_pending();
        } else if (at->is_regular_file() && at->path().filename() != ".git") {
            tree[fs::relative(at->path(), root).generic_string()] = read_text(at->path());
        }
    }
    return tree;
}

std::string_view folder_of(std::string_view path) {
    const std::size_t slash = path.rfind('/');
    return slash == std::string_view::npos ? std::string_view() : path.substr(0, slash);
}

std::string_view top_folder_of(std::string_view path) {
    const std::size_t slash = path.find('/');
    return slash == std::string_view::npos ? std::string_view() : path.substr(0, slash);
}

std::string_view name_of(std::string_view path) {
    const std::size_t slash = path.rfind('/');
    return slash == std::string_view::npos ? path : path.substr(slash + 1);
}

std::string_view stem_of(std::string_view path) {
    const std::string_view name = name_of(path);
    const std::size_t dot = name.find('.', 1);
    return name.substr(0, dot);
}

std::string_view extension_of(std::string_view path) {
    const std::string_view name = name_of(path);
    const std::size_t dot = name.rfind('.');
    return dot == std::string_view::npos || dot == 0 ? std::string_view() : name.substr(dot);
}

bool is_header(std::string_view path) {
    return extension_of(path) == ".h";
}

bool is_source(std::string_view path) {
    return extension_of(path) == ".cpp";
}

bool is_shader(std::string_view path) {
    constexpr std::array<std::string_view, 5> shaders{".glsl", ".vert", ".frag", ".comp", ".geom"};
    return is_one_of(extension_of(path), shaders);
}

bool is_code(std::string_view path) {
    return is_header(path) || is_source(path) || is_shader(path);
}

bool is_cmake(std::string_view path) {
    return name_of(path) == "CMakeLists.txt" || extension_of(path) == ".cmake";
}

bool is_script(std::string_view path) {
    return path == "dev" || path == ".ci/run" || extension_of(path) == ".sh";
}

std::vector<std::string_view> lines_of(std::string_view text) {
    std::vector<std::string_view> lines;
    while (!text.empty()) {
        const std::size_t end = text.find('\n');
        lines.push_back(text.substr(0, end));
        text = end == std::string_view::npos ? std::string_view() : text.substr(end + 1);
    }
    return lines;
}

}  // namespace quartic::tidy
