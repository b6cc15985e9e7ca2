// Cuts scene files into tokens; nothing here fails: what makes no sense is a sign.
#include "importers/pov_tokens.h"

#include "importers/text_lines.h"

#include <algorithm>
#include <charconv>
#include <limits>
#include <utility>

namespace quartic {
namespace {

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

std::size_t end_of_word(std::string_view text, std::size_t at) {
    while (at < text.size() && (is_letter(text[at]) || is_digit(text[at]))) {
        ++at;
    }
    return at;
}

}  // namespace

PovToken PovTokens::take() {
    const PovToken token = next_;
    if (token.kind == PovTokenKind::sign) {
        depth_ += (token.text == "{") - (token.text == "}");
    }
    advance();
    return token;
}

bool PovTokens::take_if(std::string_view what) {
    if (!next_.is(what)) {
        return false;
    }
    take();
    return true;
}

void PovTokens::skip_to_depth(int depth) {
    while (depth_ > depth && next_.kind != PovTokenKind::end) {
        take();
    }
}

bool PovTokens::push(std::string text) {
    if (sources_.size() > include_depth_max) {
        return false;
    }
    Source& current = sources_.back();
    if (next_.kind != PovTokenKind::end) {
        current.at = current.token_start;
        current.line = next_.line;
    }
    owned_.push_back(std::move(text));
    sources_.push_back({owned_.back(), 0, 1, 0});
    advance();
    return true;
}

// The text after // up to the line's end, or between /* and */; empty at anything else.
std::string_view PovTokens::take_comment(Source& source) {
    const std::string_view rest = source.text.substr(source.at);
    const bool line = rest.starts_with("//");
    if (!line && !rest.starts_with("/*")) {
        return {};
    }
    const std::size_t found = rest.find(line ? "\n" : "*/", 2);
    const std::size_t end = std::min(found, rest.size());
    source.line += static_cast<std::size_t>(
        std::count(rest.begin(), rest.begin() + static_cast<std::ptrdiff_t>(end), '\n'));
    source.at += std::min(rest.size(), end + (line ? 0 : 2));
    return rest.substr(0, end);
}

void PovTokens::skip_blanks(Source& source) {
    while (source.at < source.text.size()) {
        const char c = source.text[source.at];
        if (c == '\n') {
            ++source.line;
            ++source.at;
        } else if (is_blank(c)) {
            ++source.at;
        } else if (const std::string_view comment = take_comment(source); !comment.empty()) {
            next_.comment = trimmed(comment.substr(2));
        } else {
            return;
        }
    }
}

void PovTokens::read_number(Source& source) {
    const char* const first = source.text.data() + source.at;
    const char* const last = source.text.data() + source.text.size();
    next_.kind = PovTokenKind::number;
    const auto [end, error] = std::from_chars(first, last, next_.number);
    if (error == std::errc::result_out_of_range) {
        next_.number = std::numeric_limits<double>::infinity();
    }
    source.at += static_cast<std::size_t>(std::max<std::ptrdiff_t>(end - first, 1));
}

void PovTokens::read(Source& source) {
    const std::string_view text = source.text;
    const std::size_t start = source.at;
    const char c = text[start];
    const char after = start + 1 < text.size() ? text[start + 1] : '\0';
    next_.line = source.line;
    source.token_start = start;
    if (is_letter(c)) {
        next_.kind = PovTokenKind::word;
        source.at = end_of_word(text, start);
    } else if (is_digit(c) || (c == '.' && is_digit(after))) {
        read_number(source);
    } else if (c == '"') {
        const std::size_t end = std::min(text.find_first_of("\"\n", start + 1), text.size());
        next_.kind = PovTokenKind::text;
        next_.text = text.substr(start + 1, end - start - 1);
        source.at = std::min(end + 1, text.size());
        source.line += end < text.size() && text[end] == '\n';
        return;
    } else if (c == '#') {
        std::size_t word = start + 1;
        while (word < text.size() && is_blank(text[word])) {
            ++word;
        }
        next_.kind = PovTokenKind::directive;
        source.at = end_of_word(text, word);
        next_.text = text.substr(word, source.at - word);
        return;
    } else {
        next_.kind = PovTokenKind::sign;
        source.at = start + 1;
    }
    next_.text = text.substr(start, source.at - start);
}

void PovTokens::advance() {
    next_ = PovToken();
    for (;;) {
        Source& source = sources_.back();
        skip_blanks(source);
        if (source.at < source.text.size()) {
            break;
        }
        if (sources_.size() == 1) {
            next_.line = source.line;
            return;
        }
        sources_.pop_back();
    }
    in_main_ = sources_.size() == 1;
    read(sources_.back());
}

}  // namespace quartic
