// A little of C++ and GLSL: enough to see includes, calls and functions.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace quartic::tidy {

// The text with comments and the insides of literals blanked; lines and columns stay.
std::string code_without_comments(std::string_view text);

// The same, with preprocessor lines blanked too.
std::string code_without_macros(std::string_view text);

struct Include {
    std::size_t line = 0;  // from 1
    std::string path;
    bool own = false;  // in quotes, not in angle brackets
};
std::vector<Include> includes_of(std::string_view text);

// A body with a parameter list before it: a function, a method, a lambda with its statement.
struct Function {
    std::size_t line = 0;  // from 1, of its first line
    std::size_t line_count = 0;
};
std::vector<Function> functions_of(std::string_view text);

}  // namespace quartic::tidy
