// Loads models that tests write down as texts.
#pragma once

#include "importers/load.h"

#include <string>
#include <string_view>
#include <vector>

namespace quartic {

// As a file of this name, which says what format it is where its text does not.
inline Result<Scene> load_text(std::string_view text, const std::string& path) {
    const auto* first = reinterpret_cast<const std::byte*>(text.data());
    const Source source =
        Source::from_bytes(path, std::vector<std::byte>(first, first + text.size()));
    Progress progress;
    return load_scene(source, ImportOptions{}, progress);
}

}  // namespace quartic
