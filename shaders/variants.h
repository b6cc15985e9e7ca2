// Which programs there are: every shader with the defines that make it one program's text.
#pragma once

#include "primitives/shape.h"

#include <string>
#include <string_view>
#include <vector>

namespace quartic {

// How the parts of a batch are drawn.
enum class Pass {
    front,  // front faces of proxies, with conservative depth
    near,   // back faces of proxies that the near plane cuts or the eye is in
};

struct PrimitiveVariant {
    ShapeType type = ShapeType::mesh;
    int solver = 0;
    int hull_rings = 2;
    bool transparent = false;
    Pass pass = Pass::front;
};

struct ProgramText {
    std::string vertex;
    std::string fragment;
};

// A primitive's program, or, for type mesh, that of the meshes.
ProgramText program_text(const PrimitiveVariant& variant);
ProgramText resolve_text();
std::string cull_text();

// Every combination that can be asked for, by name.
struct NamedText {
    std::string file_name;  // "torus-1-front.frag"
    std::string text;
};
std::vector<NamedText> all_shader_texts();

}  // namespace quartic
