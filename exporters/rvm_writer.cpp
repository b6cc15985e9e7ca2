// Chunk headers are 24 bytes: four letters in four words, the next chunk's offset, and the word 1.
#include "exporters/rvm_writer.h"

#include <algorithm>
#include <bit>
#include <limits>

namespace quartic {
namespace {

constexpr std::size_t buffer_bytes = std::size_t{1} << 20;
constexpr std::uint64_t block_bytes = 480;
constexpr std::size_t offset_place = 16;
constexpr std::uint32_t version_of(std::string_view id) {
    return id == "HEAD" ? 2 : (id == "CNTB" ? 3 : 1);
}

void store_word(char* place, std::uint32_t word) {
    place[0] = static_cast<char>(word >> 24);
    place[1] = static_cast<char>((word >> 16) & 0xff);
    place[2] = static_cast<char>((word >> 8) & 0xff);
    place[3] = static_cast<char>(word & 0xff);
}

}  // namespace

void RvmWriter::begin(std::string_view id) {
    chunk_ = buffer_.size();
    for (const char letter : id) {
        put_word(static_cast<std::uint8_t>(letter));
    }
    put_word(0);  // the offset: end() knows it
    put_word(1);
    put_word(version_of(id));
}

void RvmWriter::put_word(std::uint32_t word) {
    char bytes[4];
    store_word(bytes, word);
    buffer_.append(bytes, 4);
}

void RvmWriter::put_float(float value) {
    put_word(std::bit_cast<std::uint32_t>(value));
}

void RvmWriter::put_vector(const glm::vec3& vector) {
    put_float(vector.x);
    put_float(vector.y);
    put_float(vector.z);
}

void RvmWriter::put_string(std::string_view text) {
    const std::size_t words = (text.size() + 3) / 4;
    put_word(static_cast<std::uint32_t>(words));
    buffer_.append(text);
    buffer_.append(4 * words - text.size(), '\0');
}

void RvmWriter::put_bytes(std::uint8_t a, std::uint8_t b, std::uint8_t c, std::uint8_t d) {
    for (const std::uint8_t byte : {a, b, c, d}) {
        buffer_.push_back(static_cast<char>(byte));
    }
}

void RvmWriter::end() {
    const std::uint64_t next = written_ + buffer_.size();
    // The padding must fit too.
    if (next > std::numeric_limits<std::uint32_t>::max() - block_bytes) {
        overflowed_ = true;
    }
    if (overflowed_) {
        buffer_.clear();
        return;
    }
    store_word(buffer_.data() + chunk_ + offset_place, static_cast<std::uint32_t>(next));
    if (buffer_.size() >= buffer_bytes) {
        output_.write(buffer_);
        written_ = next;
        buffer_.clear();
    }
}

void RvmWriter::finish() {
    const std::uint64_t length = written_ + buffer_.size();
    buffer_.append((block_bytes - length % block_bytes) % block_bytes, '\0');
    output_.write(buffer_);
    written_ += buffer_.size();
    buffer_.clear();
}

}  // namespace quartic
