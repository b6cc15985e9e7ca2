// Puts together the texts of all programs.
#include "shaders/variants.h"

#include "shaders/source.h"
#include "solvers/solver_table.h"

namespace quartic {
namespace {

std::string_view glsl_type(ShapeType type) {
    switch (type) {
#define SHAPE(id, Type, name) \
    case ShapeType::name:     \
        return #Type;
#include "primitives/catalog.h"
#undef SHAPE
        case ShapeType::mesh: break;
    }
    return "";
}

std::string defines_of(const PrimitiveVariant& variant) {
    std::string defines;
    if (variant.transparent) {
        defines += "#define TRANSPARENT\n";
    }
    if (variant.type == ShapeType::mesh) {
        return defines;
    }
    if (variant.pass == Pass::near) {
        defines += "#define NEAR\n";
    }
    if (variant.pass == Pass::large) {
        defines += "#define LARGE\n";
    }
    if (!casts_rays(variant)) {
        defines += "#define FACETS\n";
    } else if (variant.inspect) {
        defines += "#define INSPECT\n";
    }
    if (is_prepared(variant.type)) {
        // Parts whose box the near plane cuts are drawn by the other pass.
        const bool from_outside =
            variant.form % arc_forms == f32().arc_whole && variant.pass != Pass::near;
        const int form = variant.form + (from_outside ? 1 : 0);
        defines += "#define THIS_FORM " + std::to_string(form) + "\n";
    }
    defines += "#define THIS_SHAPE " + std::string(glsl_type(variant.type)) + "\n";
    defines += "#define THIS_SOLVER " + std::to_string(variant.solver) + "\n";
    defines += "#define HULL_RINGS " + std::to_string(variant.hull_rings) + "\n";
    return defines;
}

PrimitiveVariant in_pass(PrimitiveVariant variant, Pass pass) {
    variant.pass = pass;
    return variant;
}

}  // namespace

bool casts_rays(const PrimitiveVariant& variant) {
    return variant.type != ShapeType::mesh &&
           !(variant.pass != Pass::near && is_polyhedron(variant.type));
}

ProgramText program_text(const PrimitiveVariant& variant) {
    const std::string defines = defines_of(variant);
    if (variant.type == ShapeType::mesh) {
        return {shader_source("shaders/mesh.vert", defines),
                shader_source("shaders/mesh.frag", defines)};
    }
    const std::string_view fragment =
        casts_rays(variant) ? "shaders/primitive.frag" : "shaders/facet.frag";
    return {shader_source("shaders/primitive.vert", defines), shader_source(fragment, defines)};
}

ProgramText resolve_text() {
    return {shader_source("shaders/full_screen.vert", ""),
            shader_source("shaders/resolve.frag", "")};
}

std::array<NamedText, 3> cull_texts() {
    const auto text = [](const std::string& name) {
        return NamedText{name, shader_source("shaders/" + name, "")};
    };
    return {text("cull.comp"), text("cull_offsets.comp"), text("cull_lists.comp")};
}

std::vector<NamedText> all_shader_texts() {
    std::vector<NamedText> texts;
    const auto add = [&](const std::string& name, PrimitiveVariant variant) {
        const ProgramText text = program_text(variant);
        texts.push_back({name + ".vert", text.vertex});
        texts.push_back({name + ".frag", text.fragment});
        variant.inspect = casts_rays(variant);
        if (variant.inspect) {
            texts.push_back({name + "-inspect.frag", program_text(variant).fragment});
        }
    };
    for (const bool transparent : {false, true}) {
        const std::string suffix = transparent ? "-transparent" : "";
        add("mesh" + suffix, {.type = ShapeType::mesh, .transparent = transparent});
        for (const ShapeRow& shape : shape_table()) {
            for (const SolverRow& solver : solver_table()) {
                if (solver_for(shape.name, solver.id) != solver.id) {
                    continue;
                }
                const int forms = shape.prepared && !transparent ? 2 * arc_forms - 1 : 1;
                for (int form = 0; form < forms; ++form) {
                    const std::string name = std::string(shape.name) + "-" +
                                             std::to_string(solver.id) + "-" +
                                             std::to_string(form) + suffix;
                    const PrimitiveVariant variant{.type = shape.type,
                                                   .solver = solver.id,
                                                   .form = form,
                                                   .hull_rings = 4,
                                                   .transparent = transparent};
                    add(name + "-small", variant);
                    if (!shape.polyhedron) {
                        add(name + "-large", in_pass(variant, Pass::large));
                    }
                    add(name + "-near", in_pass(variant, Pass::near));
                }
            }
        }
    }
    const ProgramText resolve = resolve_text();
    texts.push_back({"resolve.vert", resolve.vertex});
    texts.push_back({"resolve.frag", resolve.fragment});
    for (const NamedText& cull : cull_texts()) {
        texts.push_back(cull);
    }
    return texts;
}

}  // namespace quartic
