// Which solver draws what: for everything at once, or for single materials.
#include "scene/pack.h"
#include "solvers/solver_table.h"
#include "viewer/app.h"

namespace quartic::viewer {

std::string solver_name(const App& app, int solver) {
    for (const SolverRow& row : solver_table()) {
        if (row.id == solver) {
            return spoken(row.name);
        }
    }
    const bool all_alike = app.drawn_solvers == std::vector<int>(app.drawn_solvers.size(), 0);
    return all_alike ? solver_name(app, solver_default) : "the materials' solvers";
}

void begin_solvers(App& app) {
    const Scene& scene = app.model->scene;
    app.packing.cancel();
    app.material_solvers.clear();
    for (const Material& material : scene.materials) {
        app.material_solvers.push_back(material.solver);
    }
    app.drawn_solvers = app.material_solvers;
    std::vector<bool> is_solved(scene.materials.size(), false);
    for (const Part& part : scene.parts) {
        if (part.material < is_solved.size() && has_solvers(name(part.type))) {
            is_solved[part.material] = true;
        }
    }
    app.solved_materials.clear();
    for (std::uint32_t i = 0; i < is_solved.size(); ++i) {
        if (is_solved[i]) {
            app.solved_materials.push_back(i);
        }
    }
}

void change_solver(App& app, int solver) {
    app.solver = solver;
    redraw(app);
}

void change_material_solver(App& app, std::uint32_t material, int solver) {
    app.material_solvers[material] = solver;
    app.packing.begin([model = app.model, solvers = app.material_solvers](const Stop&) {
        PackOptions options;
        options.material_solvers = solvers;
        return pack(model->scene, options);
    });
}

void receive_packed(App& app) {
    const std::optional<Result<Packed>> packed = app.packing.take();
    if (!packed) {
        return;
    }
    const Status loaded = *packed ? app.renderer.load(packed->value()) : Status(packed->error());
    if (!loaded) {
        app.failure = loaded.error().message;
        return;
    }
    app.drawn_solvers = app.material_solvers;
    redraw(app);
}

}  // namespace quartic::viewer
