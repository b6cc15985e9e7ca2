// Which programs there are: every shader with the defines that make it one program's text.
#pragma once

#include "primitives/shape.h"

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace quartic {

// How the parts of a batch are drawn: each by the one command of layout.glsl.
enum class Pass {
    small,  // front faces of quads, boxes or facets, with conservative depth; also meshes
    large,  // front faces of hulls or of polygons around outlines
    near,   // back faces of the boxes of those that the near plane cuts or the eye is in
};

struct PrimitiveVariant {
    ShapeType type = ShapeType::mesh;
    int solver = 0;
    int form = 0;  // of Prepared shapes
    int hull_rings = 2;
    bool transparent = false;
    Pass pass = Pass::small;
    bool inspect = false;  // its rays are recorded (inspect.glsl)
};

struct ProgramText {
    std::string vertex;
    std::string fragment;
};

// A shader's text by the name of a file, "torus-1-front.frag".
struct NamedText {
    std::string file_name;
    std::string text;
};

// Whether a variant's fragments solve rays: meshes and the facets of polyhedra do not.
bool casts_rays(const PrimitiveVariant& variant);

// A primitive's program, or, for type mesh, that of the meshes.
ProgramText program_text(const PrimitiveVariant& variant);
ProgramText resolve_text();
// The three dispatches of culling, in their order.
std::array<NamedText, 3> cull_texts();

// Every combination that can be asked for.
std::vector<NamedText> all_shader_texts();

}  // namespace quartic
