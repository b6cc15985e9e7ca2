// Text of files as UTF-8, whatever it was written in.
#pragma once

#include <string>
#include <string_view>

namespace quartic {

enum class Encoding {
    latin_1,
    utf_8,    // invalid sequences become U+FFFD
    guessed,  // valid UTF-8 is taken as such, anything else as Latin-1
};

// The text up to its first zero byte, as valid UTF-8 in out (replaced). ASCII costs one pass.
void to_utf8(std::string_view bytes, Encoding encoding, std::string& out);
std::string to_utf8(std::string_view bytes, Encoding encoding);

}  // namespace quartic
