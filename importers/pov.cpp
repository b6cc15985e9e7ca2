// Loads the objects of POV-Ray scene files (.pov), as far as they are shapes of ours.
#include "importers/formats.h"
#include "importers/pov_scene.h"

#include <array>
#include <string>

namespace quartic {
namespace {

constexpr std::uint64_t visits_least = 200'000;

std::string_view text_of(std::span<const std::byte> bytes) {
    std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    text.remove_prefix(text.starts_with("\xef\xbb\xbf") ? 3 : 0);
    return text;
}

// The language has no mark at its beginning: the name decides.
bool recognises(std::span<const std::byte> head, std::string_view extension) {
    return (extension == "pov" || extension == "inc") && !head.empty() &&
           text_of(head).find('\0') == std::string_view::npos;
}

std::string file_name(const std::string& path) {
    const std::size_t slash = path.find_last_of("/\\");
    return slash == std::string::npos ? path : path.substr(slash + 1);
}

std::string folder_of(const std::string& path) {
    const std::size_t slash = path.find_last_of('/');
    return slash == std::string::npos ? std::string(".") : path.substr(0, slash);
}

Result<Scene> load(const Source& source, const ImportOptions&, Progress& progress) {
    const std::string_view text = text_of(source.bytes());
    PovReader reader(text, folder_of(source.path()));
    if (!reader.run(progress)) {
        return Error{ErrorKind::interrupted, "", "the import was cancelled"};
    }
    progress.report(0.5);
    const PovFile file = reader.take();
    Scene scene;
    scene.title = file_name(source.path());
    scene.up_axis = "y";
    scene.findings = file.findings;
    PovSceneBuilder builder(scene, visits_least + text.size() / 8);
    for (const PovPlaced& object : file.objects) {
        if (progress.cancelled()) {
            return Error{ErrorKind::interrupted, "", "the import was cancelled"};
        }
        builder.add(object);
    }
    builder.finish();
    if (scene.parts.empty()) {
        return Error{ErrorKind::bad_data, source.path(),
                     file.first_loss.empty()
                         ? "expected objects such as quartic, cubic, sphere or mesh2 at the file's "
                           "top level, found none that can be drawn"
                         : file.first_loss};
    }
    progress.report(1.0);
    return scene;
}

}  // namespace

Importer pov_importer() {
    static constexpr std::array<std::string_view, 2> extensions{"pov", "inc"};
    return {"a POV-Ray scene (.pov)", extensions, recognises, load};
}

}  // namespace quartic
