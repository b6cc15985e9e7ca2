// Compiles and links programs; failures carry the driver's words.
#pragma once

#include "diagnostics/result.h"
#include "render/gl_objects.h"
#include "shaders/variants.h"

#include <string>

namespace quartic {

Result<GlProgram> make_program(const ProgramText& text, const std::string& name);
Result<GlProgram> make_compute_program(const std::string& text, const std::string& name);

}  // namespace quartic
