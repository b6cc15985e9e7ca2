// Names of files, files that nobody uses, markers left behind, and the sentence that opens a file.
#include "tests/tidy/code.h"
#include "tests/tidy/rules.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <regex>
#include <set>
#include <string>

namespace quartic::tidy {
namespace {

// Words that say nothing of what a file holds.
constexpr std::array<std::string_view, 10> banned_words{
    "util", "helper", "manager", "common", "misc", "base", "impl", "data", "info", "processor"};

bool is_banned(std::string_view word) {
    if (word.ends_with('s')) {
        word.remove_suffix(1);
    }
    return std::find(banned_words.begin(), banned_words.end(), word) != banned_words.end();
}

std::string_view next_word(std::string_view& stem) {
    const std::size_t end = std::min(stem.find('_'), stem.size());
    const std::string_view word = stem.substr(0, end);
    stem.remove_prefix(std::min(end + 1, stem.size()));
    return word;
}

bool is_opened_by_comment(std::string_view path) {
    return is_code(path) || extension_of(path) == ".cmake" || is_script(path) ||
           extension_of(path) == ".py" || path == "CMakeLists.txt" ||
           path == "tests/CMakeLists.txt" || path == "cmake/packages.txt";
}

// The first comment of a file without its comment signs, or empty if it has none.
std::string first_comment(std::string_view path, std::string_view text) {
    const std::string_view sign = is_code(path) ? "// " : "# ";
    std::string comment;
    bool first = true;
    for (const std::string_view line : lines_of(text)) {
        if (first && line.starts_with("#!")) {
            continue;
        }
        if (!line.starts_with(sign)) {
            break;
        }
        comment += std::string(first ? "" : " ") + std::string(line.substr(sign.size()));
        first = false;
    }
    return comment;
}

bool is_sentence(std::string_view comment) {
    const bool starts = !comment.empty() &&
                        std::islower(static_cast<unsigned char>(comment.front())) == 0 &&
                        std::isspace(static_cast<unsigned char>(comment.front())) == 0;
    const bool ends = comment.ends_with('.') || comment.ends_with(':') ||
                      comment.find(". ") != std::string_view::npos;
    return starts && ends && comment.find(' ') != std::string_view::npos;
}

// Paths and names of everything that some other file mentions.
class Mentions {
public:
    explicit Mentions(const Tree& tree) {
        for (const auto& [path, text] : tree) {
            if (is_cmake(path)) {
                add_words(in_cmake_[std::string(folder_of(path))], text);
                add_words(anywhere_in_cmake_, text);
            }
            for (const Include& include : includes_of(text)) {
                if (is_code(path) && include.path != path) {
                    included_.insert(include.path);
                }
            }
            if (extension_of(path) == ".md") {
                markdown_.push_back(&*tree.find(path));
            } else if (is_header(path) || is_source(path)) {
                add_words(in_code_, text);
            }
        }
    }

    // The folder's own CMakeLists.txt, or one above it, lists the source.
    bool is_built(std::string_view path) const {
        for (std::string_view folder = folder_of(path);; folder = folder_of(folder)) {
            const auto found = in_cmake_.find(std::string(folder));
            if (found != in_cmake_.end() && (found->second.contains(std::string(name_of(path))) ||
                                             found->second.contains(std::string(path.substr(
                                                 folder.empty() ? 0 : folder.size() + 1))))) {
                return true;
            }
            if (folder.empty()) {
                return false;
            }
        }
    }
    bool is_included(std::string_view path) const { return included_.contains(std::string(path)); }
    // A shader may be embedded by CMake or named by the renderer.
    bool is_named(std::string_view path) const {
        for (const std::string& word : {std::string(path), std::string(name_of(path))}) {
            if (anywhere_in_cmake_.contains(word) || in_code_.contains(word)) {
                return true;
            }
        }
        return false;
    }
    bool is_module(std::string_view path) const {
        return is_named(path) || anywhere_in_cmake_.contains(std::string(stem_of(path)));
    }
    bool is_in_a_page(std::string_view path) const {
        return std::any_of(markdown_.begin(), markdown_.end(), [&](const auto* page) {
            return page->first != path && page->second.find(name_of(path)) != std::string::npos;
        });
    }

private:
    static void add_words(std::set<std::string>& words, const std::string& text) {
        static const std::regex word("[\\w./-]+");
        const std::sregex_iterator end;
        for (std::sregex_iterator at(text.begin(), text.end(), word); at != end; ++at) {
            words.insert(at->str());
        }
    }

    std::map<std::string, std::set<std::string>> in_cmake_;
    std::set<std::string> anywhere_in_cmake_;
    std::set<std::string> in_code_;
    std::set<std::string> included_;
    std::vector<const Tree::value_type*> markdown_;
};

bool is_used(const Mentions& mentions, std::string_view path) {
    if (is_source(path)) {
        return mentions.is_built(path);
    }
    if (is_header(path)) {
        return mentions.is_included(path);
    }
    if (is_shader(path)) {
        return mentions.is_included(path) || mentions.is_named(path);
    }
    if (extension_of(path) == ".cmake") {
        return mentions.is_module(path);
    }
    const bool page = extension_of(path) == ".md" && top_folder_of(path) == "docs";
    return !page || name_of(path) == "README.md" || mentions.is_in_a_page(path);
}

}  // namespace

Offences find_banned_names(const Tree& tree) {
    Offences offences;
    for (const auto& [path, text] : tree) {
        std::string_view stem = stem_of(path);
        while (is_code(path) && !stem.empty()) {
            const std::string_view word = next_word(stem);
            if (is_banned(word)) {
                offences.push_back({path, 0, "'" + std::string(word) + "' says nothing of it"});
            }
        }
    }
    return offences;
}

Offences find_unused_files(const Tree& tree) {
    Offences offences;
    const Mentions mentions(tree);
    for (const auto& [path, text] : tree) {
        if (!is_used(mentions, path)) {
            offences.push_back({path, 0, "nobody builds, includes or names it"});
        }
    }
    return offences;
}

Offences find_left_markers(const Tree& tree) {
    // In two pieces each, so that this file does not offend.
    static const std::regex marker(
        "\\b(TO"
        "DO|FIX"
        "ME|XX"
        "X)\\b");
    Offences offences;
    for (const auto& [path, text] : tree) {
        std::size_t number = 0;
        for (const std::string_view line : lines_of(text)) {
            ++number;
            if (std::regex_search(line.begin(), line.end(), marker)) {
                offences.push_back({path, number, "a marker was left behind: do it or drop it"});
            }
        }
    }
    return offences;
}

Offences find_missing_first_sentences(const Tree& tree) {
    Offences offences;
    for (const auto& [path, text] : tree) {
        if (is_opened_by_comment(path) && !is_sentence(first_comment(path, text))) {
            offences.push_back({path, 1, "the first line is no sentence that says what it is"});
        }
        if (extension_of(path) == ".md" && !text.starts_with("# ")) {
            offences.push_back({path, 1, "the first line is no title"});
        }
    }
    return offences;
}

}  // namespace quartic::tidy
