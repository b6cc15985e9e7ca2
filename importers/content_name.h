// Tells what a file is that no importer reads, so that the error can name it.
#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace quartic {

// "a PNG image", "an empty file", "text that begins with ...", or the first bytes.
std::string content_name(std::span<const std::byte> head);

}  // namespace quartic
