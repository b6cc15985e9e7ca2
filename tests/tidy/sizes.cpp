// How long lines, functions and files may be.
#include "tests/tidy/code.h"
#include "tests/tidy/rules.h"

#include <algorithm>
#include <string>

namespace quartic::tidy {
namespace {

constexpr std::size_t columns_max = 100;
constexpr std::size_t page_columns_max = 132;  // prose, which many editors wrap by themselves
constexpr std::size_t function_lines_max = 70;

// Lines that a file may have; 0: any number.
std::size_t lines_max(std::string_view path) {
    if (is_header(path)) {
        return 250;
    }
    if (is_source(path)) {
        return 500;
    }
    if (is_shader(path)) {
        const std::string_view folder = top_folder_of(path);
        return folder == "primitives" ? 180 : (folder == "solvers" ? 200 : 150);
    }
    return name_of(path) == "CMakeLists.txt" ? 100 : 0;
}

// Columns of UTF-8: continuation bytes take none.
std::size_t columns_of(std::string_view line) {
    return static_cast<std::size_t>(std::count_if(line.begin(), line.end(), [](char c) {
        return (static_cast<unsigned char>(c) & 0xc0u) != 0x80u;
    }));
}

bool has_columns(std::string_view path) {
    return is_code(path) || is_cmake(path) || is_script(path) || extension_of(path) == ".md" ||
           extension_of(path) == ".py" || extension_of(path) == ".js";
}

}  // namespace

Offences find_long_lines(const Tree& tree) {
    Offences offences;
    for (const auto& [path, text] : tree) {
        std::size_t number = 0;
        for (const std::string_view line : lines_of(text)) {
            ++number;
            // A row of a Markdown table cannot be broken.
            const bool page = extension_of(path) == ".md";
            const std::size_t most = page ? page_columns_max : columns_max;
            if (has_columns(path) && !(page && line.starts_with('|')) && columns_of(line) > most) {
                offences.push_back({path, number,
                                    std::to_string(columns_of(line)) + " columns, at most " +
                                        std::to_string(most)});
            }
        }
    }
    return offences;
}

Offences find_long_functions(const Tree& tree) {
    Offences offences;
    for (const auto& [path, text] : tree) {
        if (!is_code(path)) {
            continue;
        }
        for (const Function& function : functions_of(text)) {
            if (function.line_count > function_lines_max) {
                offences.push_back({path, function.line,
                                    "a function of " + std::to_string(function.line_count) +
                                        " lines, at most 70"});
            }
        }
    }
    return offences;
}

Offences find_long_files(const Tree& tree) {
    Offences offences;
    for (const auto& [path, text] : tree) {
        const std::size_t count = lines_of(text).size();
        const std::size_t most = lines_max(path);
        if (most > 0 && count > most) {
            offences.push_back(
                {path, 0, std::to_string(count) + " lines, at most " + std::to_string(most)});
        }
    }
    return offences;
}

}  // namespace quartic::tidy
