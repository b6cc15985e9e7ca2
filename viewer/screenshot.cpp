// Writes the picture as PNG beside nothing that exists: MODEL.png, MODEL_1.png, ...
#include "files/output.h"
#include "viewer/app.h"

#include <filesystem>
#include <system_error>

// Private to this file: other parts may have their own.
#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb/stb_image_write.h>

namespace quartic::viewer {
namespace {

namespace fs = std::filesystem;

constexpr int names_max = 10000;

// In the current folder, named after the model.
std::string free_name(const std::string& model) {
    const std::string stem = fs::path(model).stem().string();
    std::error_code
        ignored;  // a folder that cannot be read cannot be written either, and that is told
    for (int i = 0; i < names_max; ++i) {
        const std::string name = stem + (i == 0 ? "" : "_" + std::to_string(i)) + ".png";
        if (!fs::exists(name, ignored)) {
            return fs::absolute(name, ignored).string();
        }
    }
    return stem + ".png";
}

void append_bytes(void* context, void* bytes, int count) {
    auto& all = *static_cast<std::vector<std::byte>*>(context);
    const auto* const first = static_cast<const std::byte*>(bytes);
    all.insert(all.end(), first, first + count);
}

}  // namespace

void write_screenshot(App& app) {
    app.screenshot_wanted = false;
    const PixelSize size = is_map_shown(app) ? app.maps.size : app.picture.size_px();
    if (!app.model || size.width < 1) {
        return;
    }
    const std::vector<std::uint8_t> rgba = seen_pixels(app);
    const int row_bytes = size.width * 4;
    const std::uint8_t* const top =
        rgba.data() + static_cast<std::ptrdiff_t>(row_bytes) * (size.height - 1);
    std::vector<std::byte> file;
    // A negative stride turns the picture over.
    if (stbi_write_png_to_func(append_bytes, &file, size.width, size.height, 4, top, -row_bytes) ==
        0) {
        app.failure = "The picture cannot be encoded as PNG: out of memory.";
        return;
    }
    const std::string path = free_name(app.model->path);
    const Status written = write_file(path, file);
    if (written) {
        app.notice = "Saved " + path;
    } else {
        app.failure = written.error().where + ": " + written.error().message;
    }
}

}  // namespace quartic::viewer
