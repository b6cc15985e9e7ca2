// Who may include whom, who may use which library, and who may speak to OpenGL.
#include "tests/tidy/code.h"
#include "tests/tidy/rules.h"

#include <algorithm>
#include <regex>
#include <string>

namespace quartic::tidy {
namespace {

constexpr std::size_t own_includes_max = 12;

struct Folder {
    std::string_view name;
    std::string_view may_include;  // besides itself
};

// The drawing of docs/architecture.md as a table.
constexpr Folder folders[] = {
    {"diagnostics", ""},
    {"files", "diagnostics"},
    {"solvers", ""},
    {"primitives", "solvers diagnostics"},
    {"scene", "primitives solvers shaders files diagnostics"},
    {"shaders", "primitives solvers diagnostics"},
    {"importers", "scene primitives solvers files diagnostics"},
    {"exporters", "scene primitives solvers files diagnostics"},
    {"generators", "scene primitives solvers files diagnostics"},
    {"render", "scene primitives solvers shaders files diagnostics"},
    {"viewer", "render scene importers exporters primitives solvers shaders files diagnostics"},
    {"bench",
     "render scene importers exporters generators primitives solvers shaders files diagnostics"},
    {"cli",
     "bench viewer render scene importers exporters generators primitives solvers shaders files "
     "diagnostics"},
};

struct Library {
    std::string_view prefix;  // of the path in angle brackets
    std::string_view homes;   // the only folders that may include it, besides tests
};

constexpr Library libraries[] = {
    {"epoxy/", "render viewer"},
    {"GL/", "render viewer"},
    {"EGL/", "render viewer"},
    {"GLFW/", "viewer"},
    {"imgui", "viewer"},
    {"embree", "scene"},
    {"CLI/", "cli"},
    {"tinyexr", "cli"},
    {"stb/", "cli viewer"},
};

bool has_word(std::string_view words, std::string_view word) {
    while (!words.empty()) {
        const std::size_t end = std::min(words.find(' '), words.size());
        if (words.substr(0, end) == word) {
            return true;
        }
        words.remove_prefix(std::min(end + 1, words.size()));
    }
    return false;
}

const Folder* find_folder(std::string_view name) {
    const auto* found = std::find_if(std::begin(folders), std::end(folders),
                                     [&](const Folder& folder) { return folder.name == name; });
    return found == std::end(folders) ? nullptr : found;
}

// Why this folder may not have this include, or empty.
std::string include_fault(std::string_view folder, const Include& include, const Tree& tree) {
    if (!include.own) {
        return {};
    }
    if (!tree.contains(include.path)) {
        return "\"" + include.path + "\" is no path from the root of the tree";
    }
    const std::string_view target = top_folder_of(include.path);
    const Folder* rules_of_folder = find_folder(folder);
    if (folder == "tests" || folder == target) {
        return {};
    }
    if (rules_of_folder == nullptr) {
        return "the folder " + std::string(folder) + " is not in the table of tests/tidy";
    }
    return has_word(rules_of_folder->may_include, target)
               ? std::string()
               : std::string(folder) + " may not include " + std::string(target);
}

}  // namespace

Offences find_forbidden_includes(const Tree& tree) {
    Offences offences;
    for (const auto& [path, text] : tree) {
        if (!is_code(path)) {
            continue;
        }
        for (const Include& include : includes_of(text)) {
            const std::string fault = include_fault(top_folder_of(path), include, tree);
            if (!fault.empty()) {
                offences.push_back({path, include.line, fault});
            }
        }
    }
    return offences;
}

Offences find_foreign_includes(const Tree& tree) {
    Offences offences;
    for (const auto& [path, text] : tree) {
        const std::string_view folder = top_folder_of(path);
        if (!is_code(path) || folder == "tests") {
            continue;
        }
        for (const Include& include : includes_of(text)) {
            for (const Library& library : libraries) {
                const bool matches = !include.own && include.path.starts_with(library.prefix);
                if (matches && !has_word(library.homes, folder)) {
                    offences.push_back({path, include.line,
                                        "<" + include.path + "> belongs to " +
                                            std::string(library.homes) + " alone"});
                }
            }
        }
    }
    return offences;
}

Offences find_gl_calls(const Tree& tree) {
    static const std::regex call("\\b(gl[A-Z]\\w*\\s*\\(|GL_[A-Z]\\w*)");
    Offences offences;
    for (const auto& [path, text] : tree) {
        const std::string_view folder = top_folder_of(path);
        if (folder == "render" || folder == "viewer" || folder == "tests" ||
            !(is_header(path) || is_source(path))) {
            continue;
        }
        std::size_t number = 0;
        const std::string code = code_without_comments(text);
        for (const std::string_view line : lines_of(code)) {
            ++number;
            if (std::regex_search(line.begin(), line.end(), call)) {
                offences.push_back({path, number, "only render and viewer speak to OpenGL"});
            }
        }
    }
    return offences;
}

Offences find_many_includes(const Tree& tree) {
    Offences offences;
    for (const auto& [path, text] : tree) {
        // catalog.h and all.glsl are lists of includes by nature.
        if (!is_code(path) || name_of(path) == "catalog.h" || name_of(path) == "all.glsl") {
            continue;
        }
        const std::vector<Include> includes = includes_of(text);
        std::vector<std::string> own;
        for (const Include& include : includes) {
            if (include.own && std::find(own.begin(), own.end(), include.path) == own.end()) {
                own.push_back(include.path);
            }
        }
        if (own.size() > own_includes_max) {
            offences.push_back({path, 0, std::to_string(own.size()) + " own includes, at most 12"});
        }
    }
    return offences;
}

}  // namespace quartic::tidy
