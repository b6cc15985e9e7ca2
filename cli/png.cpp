// Encodes PNG in memory, then writes it as any other output.
#include "cli/png.h"

#include "files/output.h"

#include <vector>

// Private to this file: other parts may have their own.
#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb/stb_image_write.h>

namespace quartic::cli {
namespace {

void append_bytes(void* context, void* bytes, int count) {
    auto& all = *static_cast<std::vector<std::byte>*>(context);
    const auto* first = static_cast<const std::byte*>(bytes);
    all.insert(all.end(), first, first + count);
}

}  // namespace

Status write_png(const std::string& path, PixelSize size, std::span<const std::uint8_t> rgba) {
    const std::size_t row_bytes = static_cast<std::size_t>(size.width) * 4;
    CHECK(rgba.size() == row_bytes * static_cast<std::size_t>(size.height));
    // A negative stride turns the picture over.
    const std::uint8_t* top = rgba.data() + row_bytes * static_cast<std::size_t>(size.height - 1);
    std::vector<std::byte> file;
    const int written = stbi_write_png_to_func(append_bytes, &file, size.width, size.height, 4, top,
                                               -size.width * 4);
    if (written == 0) {
        return Error{ErrorKind::io, path, "cannot be encoded as PNG: out of memory"};
    }
    return write_file(path, file);
}

}  // namespace quartic::cli
