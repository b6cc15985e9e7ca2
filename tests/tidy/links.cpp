// Folders that explain themselves, and links that lead somewhere.
#include "tests/tidy/rules.h"

#include <filesystem>
#include <regex>
#include <set>
#include <string>

namespace quartic::tidy {
namespace {

std::set<std::string> folders_of(const Tree& tree) {
    std::set<std::string> folders;
    for (const auto& [path, text] : tree) {
        for (std::string_view at = folder_of(path); !at.empty(); at = folder_of(at)) {
            folders.insert(std::string(at));
        }
    }
    return folders;
}

std::string text_of(const Tree& tree, const std::string& path) {
    const auto found = tree.find(path);
    return found == tree.end() ? std::string() : found->second;
}

bool explains_itself(const Tree& tree, const std::string& folder) {
    if (tree.contains(folder + "/README.md") || folder.starts_with('.')) {
        return true;
    }
    const std::string above(folder_of(folder));
    const std::string name = std::string(name_of(folder)) + "/";
    return !above.empty() && text_of(tree, above + "/README.md").find(name) != std::string::npos;
}

bool leads_somewhere(const std::set<std::string>& folders, const Tree& tree, std::string_view page,
                     std::string target) {
    target = target.substr(0, target.find('#'));
    if (target.empty() || target.find("://") != std::string::npos ||
        target.starts_with("mailto:")) {
        return true;
    }
    const std::filesystem::path joined = std::filesystem::path(folder_of(page)) / target;
    std::string path = joined.lexically_normal().generic_string();
    if (path.ends_with('/')) {
        path.pop_back();
    }
    return tree.contains(path) || folders.contains(path) || path == ".";
}

}  // namespace

// A folder in a folder may be explained by the README above it.
Offences find_folders_without_readme(const Tree& tree) {
    Offences offences;
    for (const std::string& folder : folders_of(tree)) {
        if (!explains_itself(tree, folder)) {
            offences.push_back({folder, 0, "no README.md here, and none above names it"});
        }
    }
    return offences;
}

Offences find_dead_links(const Tree& tree) {
    static const std::regex link("\\]\\(([^)\\s]+)[^)]*\\)");
    Offences offences;
    const std::set<std::string> folders = folders_of(tree);
    for (const auto& [path, text] : tree) {
        if (extension_of(path) != ".md") {
            continue;
        }
        std::size_t number = 0;
        for (const std::string_view line : lines_of(text)) {
            ++number;
            const std::string one(line);
            const std::sregex_iterator end;
            for (std::sregex_iterator at(one.begin(), one.end(), link); at != end; ++at) {
                if (!leads_somewhere(folders, tree, path, (*at)[1])) {
                    offences.push_back({path, number, (*at)[1].str() + " leads nowhere"});
                }
            }
        }
    }
    return offences;
}

}  // namespace quartic::tidy
