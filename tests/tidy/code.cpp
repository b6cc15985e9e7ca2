// Blanks comments and literals; finds includes and functions by their brackets.
#include "tests/tidy/code.h"

#include "tests/tidy/tree.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>

namespace quartic::tidy {
namespace {

void blank(std::string& text, std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < std::min(last, text.size()); ++i) {
        text[i] = text[i] == '\n' ? '\n' : ' ';
    }
}

// Where the literal that opens at this quote ends: the index of its closing quote.
std::size_t end_of_literal(std::string_view text, std::size_t quote) {
    std::size_t i = quote + 1;
    while (i < text.size() && text[i] != text[quote] && text[i] != '\n') {
        i += text[i] == '\\' ? std::size_t{2} : std::size_t{1};
    }
    return std::min(i, text.size());
}

// Where the raw string whose R stands before this quote ends: one past its closing quote.
std::size_t end_of_raw_literal(std::string_view text, std::size_t quote) {
    const std::size_t open = text.find('(', quote);
    if (open == std::string_view::npos) {
        return text.size();
    }
    std::string close(1, ')');
    close.append(text.substr(quote + 1, open - quote - 1)).append(1, '"');
    const std::size_t end = text.find(close, open);
    return end == std::string_view::npos ? text.size() : end + close.size();
}

bool is_word(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

// 1'000'000 holds no character literal.
bool is_digit_separator(std::string_view text, std::size_t i) {
    return text[i] == '\'' && i > 0 && is_word(text[i - 1]);
}

// Blanks what begins at i if it is a comment or a literal; returns where to go on.
std::size_t blank_one(std::string& code, std::string_view text, std::size_t i) {
    if (text.substr(i, 2) == "//") {
        const std::size_t end = std::min(text.find('\n', i), text.size());
        blank(code, i, end);
        return end;
    }
    if (text.substr(i, 2) == "/*") {
        const std::size_t close = text.find("*/", i + 2);
        const std::size_t end = close == std::string_view::npos ? text.size() : close + 2;
        blank(code, i, end);
        return end;
    }
    if (text[i] == '"' && i > 0 && text[i - 1] == 'R') {
        const std::size_t end = end_of_raw_literal(text, i);
        blank(code, i + 1, end - 1);
        return end;
    }
    if (text[i] == '"' || (text[i] == '\'' && !is_digit_separator(text, i))) {
        const std::size_t end = end_of_literal(text, i);
        blank(code, i + 1, end);
        return end + 1;
    }
    return i + 1;
}

std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t\n");
    return first == std::string_view::npos ? std::string_view() : text.substr(first);
}

// Whether the text before an opening brace makes it the body of a function.
bool is_function_head(std::string_view head) {
    constexpr std::array<std::string_view, 13> others{
        "if",  "for",    "while", "switch", "else",      "do",   "catch",
        "try", "struct", "class", "enum",   "namespace", "union"};
    head = trimmed(head);
    const auto end = std::find_if_not(head.begin(), head.end(), is_word);
    const std::string_view first_word =
        head.substr(0, static_cast<std::size_t>(end - head.begin()));
    const bool other = std::find(others.begin(), others.end(), first_word) != others.end();
    const bool lambda = head.find("](") != std::string_view::npos;
    return head.find(')') != std::string_view::npos && (!other || lambda);
}

}  // namespace

std::string code_without_comments(std::string_view text) {
    std::string code(text);
    for (std::size_t i = 0; i < text.size();) {
        i = blank_one(code, text, i);
    }
    return code;
}

std::string code_without_macros(std::string_view text) {
    std::string code = code_without_comments(text);
    bool goes_on = false;
    std::size_t start = 0;
    const std::string whole = code;  // the lines look into it while code is blanked
    for (const std::string_view line : lines_of(whole)) {
        const bool macro = goes_on || trimmed(line).starts_with('#');
        goes_on = macro && line.ends_with('\\');
        if (macro) {
            blank(code, start, start + line.size());
        }
        start += line.size() + 1;
    }
    return code;
}

std::vector<Include> includes_of(std::string_view text) {
    std::vector<Include> includes;
    std::size_t number = 0;
    for (const std::string_view line : lines_of(text)) {
        ++number;
        const std::string_view code = trimmed(line);
        if (!code.starts_with("#include")) {
            continue;
        }
        const std::size_t open = code.find_first_of("\"<");
        const std::size_t close = code.find_last_of("\">");
        if (open != std::string_view::npos && close > open) {
            const std::string_view path = code.substr(open + 1, close - open - 1);
            includes.push_back({number, std::string(path), code[open] == '"'});
        }
    }
    return includes;
}

std::vector<Function> functions_of(std::string_view text) {
    struct Brace {
        bool function;
        std::size_t line;  // where its statement began
        int parentheses;   // open ones outside it
    };
    const std::string code = code_without_macros(text);
    std::vector<Function> functions;
    std::vector<Brace> open;
    std::size_t line = 1;
    std::size_t head = 0;       // where the statement began
    std::size_t head_line = 0;  // 0: it has not begun
    int parentheses = 0;
    for (std::size_t i = 0; i < code.size(); ++i) {
        const char c = code[i];
        if (head_line == 0 && c != ' ' && c != '\n') {
            head_line = line;
        }
        line += c == '\n' ? 1 : 0;
        parentheses += c == '(' ? 1 : (c == ')' ? -1 : 0);
        if (c == '{') {
            const std::string_view before = std::string_view(code).substr(head, i - head);
            open.push_back({is_function_head(before), head_line, parentheses});
            parentheses = 0;
        } else if (c == '}' && !open.empty()) {
            if (open.back().function) {
                functions.push_back({open.back().line, line - open.back().line + 1});
            }
            parentheses = open.back().parentheses;
            open.pop_back();
        }
        if (c == '{' || c == '}' || (c == ';' && parentheses == 0)) {
            head = i + 1;
            head_line = 0;
        }
    }
    return functions;
}

}  // namespace quartic::tidy
