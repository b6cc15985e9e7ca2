// Lines of a text in memory, with their numbers; any line ending.
#pragma once

#include <cstddef>
#include <string_view>

namespace quartic {

inline bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\f' || c == '\v';
}

inline std::string_view trimmed(std::string_view text) {
    while (!text.empty() && is_blank(text.front())) {
        text.remove_prefix(1);
    }
    while (!text.empty() && is_blank(text.back())) {
        text.remove_suffix(1);
    }
    return text;
}

class LineReader {
public:
    explicit LineReader(std::string_view text) : rest_(text) {}

    // The line without its ending (a carriage return before it is left for trimmed()); false after
    // the last.
    bool next(std::string_view& line) {
        if (rest_.empty()) {
            return false;
        }
        const std::size_t end = rest_.find('\n');
        ended_ = end != std::string_view::npos;
        line = rest_.substr(0, end);
        rest_.remove_prefix(ended_ ? end + 1 : rest_.size());
        ++number_;
        return true;
    }
    std::size_t number() const { return number_; }  // of the line read last, from 1
    bool ended() const { return ended_; }           // false: the text stopped within it
    bool at_end() const { return rest_.empty(); }

private:
    std::string_view rest_;
    std::size_t number_ = 0;
    bool ended_ = true;
};

}  // namespace quartic
