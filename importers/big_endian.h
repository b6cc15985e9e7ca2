// Big-endian words and floats of a byte range that the caller has measured.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace quartic {

inline std::uint32_t word_at(const std::byte* at) {
    std::uint32_t word = 0;
    std::memcpy(&word, at, sizeof word);
    if constexpr (std::endian::native == std::endian::little) {
        word = __builtin_bswap32(word);
    }
    return word;
}

inline float float_at(const std::byte* at) {
    return std::bit_cast<float>(word_at(at));
}

inline void read_floats(const std::byte* at, float* out, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        out[i] = float_at(at + 4 * i);
    }
}

}  // namespace quartic
