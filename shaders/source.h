// The texts of the shaders, with their includes expanded.
#pragma once

#include <string>
#include <string_view>

namespace quartic {

// "#version", then the defines (lines of "#define ..."), then the file and all that it includes.
// Files come from the program itself, or, where the environment names a source tree in
// QUARTIC_SHADER_TREE, from there.
std::string shader_source(std::string_view path, std::string_view defines);

}  // namespace quartic
