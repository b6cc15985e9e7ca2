// Encodes OpenEXR in memory, then writes it as any other output.
#include "cli/exr.h"

#include "files/output.h"

#include <tinyexr.h>

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <vector>

namespace quartic::cli {
namespace {

std::vector<float> turned_over(PixelSize size, std::span<const float> rows) {
    const auto width = static_cast<std::size_t>(size.width);
    std::vector<float> turned;
    turned.reserve(rows.size());
    for (std::size_t row = static_cast<std::size_t>(size.height); row-- > 0;) {
        const auto one = rows.subspan(row * width, width);
        turned.insert(turned.end(), one.begin(), one.end());
    }
    return turned;
}

struct Free {
    void operator()(unsigned char* bytes) const { std::free(bytes); }
};

}  // namespace

Status write_depth_exr(const std::string& path, PixelSize size, std::span<const float> depth_m) {
    std::vector<float> rows = turned_over(size, depth_m);
    auto* channel = reinterpret_cast<unsigned char*>(rows.data());
    EXRImage image;
    InitEXRImage(&image);
    image.num_channels = 1;
    image.images = &channel;
    image.width = size.width;
    image.height = size.height;

    EXRChannelInfo depth{};
    depth.name[0] = 'Z';
    int type = TINYEXR_PIXELTYPE_FLOAT;
    EXRHeader header;
    InitEXRHeader(&header);
    header.num_channels = 1;
    header.channels = &depth;
    header.pixel_types = &type;
    header.requested_pixel_types = &type;
    header.compression_type = TINYEXR_COMPRESSIONTYPE_ZIP;

    unsigned char* memory = nullptr;
    const char* message = nullptr;
    const std::size_t bytes = SaveEXRImageToMemory(&image, &header, &memory, &message);
    const std::unique_ptr<unsigned char, Free> owner(memory);
    if (bytes == 0) {
        Error error{ErrorKind::io, path, "cannot be encoded as OpenEXR"};
        if (message != nullptr) {
            error.message += std::string(": ") + message;
            FreeEXRErrorMessage(message);
        }
        return error;
    }
    return write_file(path, std::as_bytes(std::span(memory, bytes)));
}

}  // namespace quartic::cli
