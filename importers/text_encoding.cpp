// Latin-1 and damaged UTF-8 to sound UTF-8.
#include "importers/text_encoding.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace quartic {
namespace {

constexpr std::string_view replacement = "\xef\xbf\xbd";

std::uint8_t byte_at(std::string_view text, std::size_t at) {
    return static_cast<std::uint8_t>(text[at]);
}

bool is_continuation(std::string_view text, std::size_t at) {
    return at < text.size() && (byte_at(text, at) & 0xc0) == 0x80;
}

// Bytes of the sound sequence at this place, or 0 (table 3-7 of the Unicode standard).
std::size_t sequence_length(std::string_view text, std::size_t at) {
    const std::uint8_t first = byte_at(text, at);
    if (first < 0x80) {
        return 1;
    }
    if (first < 0xc2 || first > 0xf4 || !is_continuation(text, at + 1)) {
        return 0;
    }
    const std::uint8_t second = byte_at(text, at + 1);
    if (first < 0xe0) {
        return 2;
    }
    const bool surrogate_or_long =
        (first == 0xe0 && second < 0xa0) || (first == 0xed && second > 0x9f) ||
        (first == 0xf0 && second < 0x90) || (first == 0xf4 && second > 0x8f);
    if (surrogate_or_long || !is_continuation(text, at + 2)) {
        return 0;
    }
    if (first < 0xf0) {
        return 3;
    }
    return is_continuation(text, at + 3) ? 4 : 0;
}

bool is_utf8(std::string_view text) {
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t length = sequence_length(text, at);
        if (length == 0) {
            return false;
        }
        at += length;
    }
    return true;
}

void append_latin_1(std::string_view text, std::string& out) {
    for (const char c : text) {
        const auto code = static_cast<std::uint8_t>(c);
        if (code < 0x80) {
            out += c;
        } else {
            out += static_cast<char>(0xc0 | (code >> 6));
            out += static_cast<char>(0x80 | (code & 0x3f));
        }
    }
}

void append_utf_8(std::string_view text, std::string& out) {
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t length = sequence_length(text, at);
        out += length == 0 ? replacement : text.substr(at, length);
        at += std::max<std::size_t>(length, 1);
    }
}

}  // namespace

void to_utf8(std::string_view bytes, Encoding encoding, std::string& out) {
    bytes = bytes.substr(0, std::min(bytes.find('\0'), bytes.size()));
    out.clear();
    const bool ascii = std::all_of(bytes.begin(), bytes.end(),
                                   [](char c) { return static_cast<std::uint8_t>(c) < 0x80; });
    if (ascii) {
        out.assign(bytes);
        return;
    }
    if (encoding == Encoding::latin_1 || (encoding == Encoding::guessed && !is_utf8(bytes))) {
        append_latin_1(bytes, out);
    } else {
        append_utf_8(bytes, out);
    }
}

std::string to_utf8(std::string_view bytes, Encoding encoding) {
    std::string text;
    to_utf8(bytes, encoding, text);
    return text;
}

}  // namespace quartic
