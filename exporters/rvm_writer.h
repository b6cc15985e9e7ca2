// Writes the chunks of binary RVM files: big-endian words, and the offset of every next chunk.
#pragma once

#include "files/output.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <string>
#include <string_view>

namespace quartic {

// One chunk is open at a time: begin, put its payload, end. Everything after an overflow is
// dropped.
class RvmWriter {
public:
    explicit RvmWriter(Output& output) : output_(output) {}

    void begin(std::string_view id);  // four letters; the version word is put first
    void put_word(std::uint32_t word);
    void put_float(float value);
    void put_vector(const glm::vec3& vector);
    void put_string(std::string_view text);
    void put_bytes(std::uint8_t a, std::uint8_t b, std::uint8_t c, std::uint8_t d);
    void end();

    // Zeros up to a multiple of the block that PDMS writes; then everything is with the output.
    void finish();

    // Offsets are words of 32 bits: whether the file would have become longer than they reach.
    bool overflowed() const { return overflowed_; }

private:
    Output& output_;
    std::string buffer_;
    std::size_t chunk_ = 0;      // where the open chunk begins in the buffer
    std::uint64_t written_ = 0;  // what the output has already
    bool overflowed_ = false;
};

}  // namespace quartic
