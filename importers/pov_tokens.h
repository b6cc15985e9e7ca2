// Words, numbers and signs of POV-Ray's scene language, with the lines that they stand on.
#pragma once

#include <cstddef>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

namespace quartic {

enum class PovTokenKind { end, word, number, text, sign, directive };

struct PovToken {
    PovTokenKind kind = PovTokenKind::end;
    std::string_view text;  // of a directive and of a quoted text what is inside
    double number = 0.0;
    std::size_t line = 0;
    std::string_view comment;  // the last one before it, without its marks

    bool is(std::string_view what) const {
        return (kind == PovTokenKind::word || kind == PovTokenKind::sign) && text == what;
    }
    bool is_directive(std::string_view what) const {
        return kind == PovTokenKind::directive && text == what;
    }
};

// Looks one token ahead. Texts that are pushed (included files) are read before what follows.
class PovTokens {
public:
    static constexpr std::size_t include_depth_max = 8;

    explicit PovTokens(std::string_view text) {
        sources_.push_back({text, 0, 1, 0});
        advance();
    }

    const PovToken& peek() const { return next_; }
    PovToken take();
    bool take_if(std::string_view what);  // a word or sign

    // Braces that are open after the tokens taken so far.
    int depth() const { return depth_; }
    // Takes tokens until this many braces are open, the closing one included.
    void skip_to_depth(int depth);

    std::size_t include_depth() const { return sources_.size(); }
    // Before the token that peek() shows, which is read again afterwards. False if nested too deep.
    bool push(std::string text);

    // False while an included text is read.
    bool in_main() const { return next_.kind == PovTokenKind::end || in_main_; }

private:
    struct Source {
        std::string_view text;
        std::size_t at;
        std::size_t line;
        std::size_t token_start;  // of the token that was read last
    };

    void advance();
    void skip_blanks(Source& source);
    std::string_view take_comment(Source& source);
    void read(Source& source);
    void read_number(Source& source);

    std::vector<Source> sources_;
    std::deque<std::string> owned_;
    PovToken next_;
    int depth_ = 0;
    bool in_main_ = true;
};

}  // namespace quartic
