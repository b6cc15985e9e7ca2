// A file's bytes, memory-mapped read-only; "-" reads standard input.
#pragma once

#include "diagnostics/result.h"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace quartic {

// Movable owner of the bytes. Only regular files are mapped: a directory, a FIFO or a device is an
// error at once.
class Source {
public:
    static Result<Source> open(const std::string& path);
    static Source from_bytes(std::string name, std::vector<std::byte> bytes);

    Source(Source&& other) noexcept;
    Source& operator=(Source&& other) noexcept;
    Source(const Source&) = delete;
    Source& operator=(const Source&) = delete;
    ~Source();

    std::span<const std::byte> bytes() const { return bytes_; }
    const std::string& path() const { return path_; }

private:
    Source() = default;

    std::string path_;
    std::vector<std::byte> owned_;
    std::span<const std::byte> bytes_;
    void* mapping_ = nullptr;
};

}  // namespace quartic
