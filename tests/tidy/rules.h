// The rules of the tree, each a function from the tree to what offends against it.
#pragma once

#include "tests/tidy/tree.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace quartic::tidy {

struct Offence {
    std::string path;
    std::size_t line = 0;  // from 1; 0: the whole file
    std::string what;
};
using Offences = std::vector<Offence>;

struct Rule {
    std::string_view name;
    Offences (*find)(const Tree&);
};
std::span<const Rule> rules();

// An offence that is meant, and why.
struct Exception {
    std::string_view rule;
    std::string_view path;
    std::string_view reason;
};
std::span<const Exception> exceptions();

// includes.cpp
Offences find_forbidden_includes(const Tree& tree);
Offences find_foreign_includes(const Tree& tree);
Offences find_gl_calls(const Tree& tree);
Offences find_many_includes(const Tree& tree);

// sizes.cpp
Offences find_long_lines(const Tree& tree);
Offences find_long_functions(const Tree& tree);
Offences find_long_files(const Tree& tree);

// names.cpp
Offences find_banned_names(const Tree& tree);
Offences find_unused_files(const Tree& tree);
Offences find_left_markers(const Tree& tree);
Offences find_missing_first_sentences(const Tree& tree);

// links.cpp
Offences find_folders_without_readme(const Tree& tree);
Offences find_dead_links(const Tree& tree);

}  // namespace quartic::tidy
