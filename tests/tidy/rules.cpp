// The table of rules, and the exceptions with their reasons.
#include "tests/tidy/rules.h"

namespace quartic::tidy {
namespace {

constexpr Rule table[] = {
    {"forbidden_include", find_forbidden_includes},
    {"foreign_include", find_foreign_includes},
    {"gl_call", find_gl_calls},
    {"many_includes", find_many_includes},
    {"long_line", find_long_lines},
    {"long_function", find_long_functions},
    {"long_file", find_long_files},
    {"banned_name", find_banned_names},
    {"unused_file", find_unused_files},
    {"left_marker", find_left_markers},
    {"first_sentence", find_missing_first_sentences},
    {"folder_without_readme", find_folders_without_readme},
    {"dead_link", find_dead_links},
};

constexpr Exception list[] = {
    {"banned_name", "cli/info.cpp", "the verb is called info, and a verb's file has its name"},
};

}  // namespace

std::span<const Rule> rules() {
    return table;
}

std::span<const Exception> exceptions() {
    return list;
}

}  // namespace quartic::tidy
