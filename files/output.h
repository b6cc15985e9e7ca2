// A file that appears whole or not at all: written beside its place, synced, then renamed.
#pragma once

#include "diagnostics/result.h"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace quartic {

// Write, then commit. Without commit() the target is as it was, and nothing is left beside it. "-"
// is standard output.
class Output {
public:
    static Result<Output> create(const std::string& path);

    // Appends to the bytes of the caller, which must outlive it; commit() brings the last of them.
    static Output to_memory(std::vector<std::byte>& bytes);

    Output(Output&& other) noexcept;
    Output& operator=(Output&& other) = delete;
    Output(const Output&) = delete;
    Output& operator=(const Output&) = delete;
    ~Output();

    // Buffered; a failure is kept and reported by commit().
    void write(std::span<const std::byte> bytes);
    void write(std::string_view text) { write(std::as_bytes(std::span(text))); }

    Status commit();

private:
    Output() = default;
    void flush();

    std::string path_;
    std::string temporary_path_;
    std::string buffer_;
    std::vector<std::byte>* memory_ = nullptr;  // instead of a file
    int descriptor_ = -1;
    int failure_ = 0;  // errno of the first failed write
};

// The whole file in one call.
Status write_file(const std::string& path, std::span<const std::byte> bytes);

}  // namespace quartic
