// Which solver draws what: for everything at once, or for single materials.
#include "scene/pack.h"
#include "solvers/solver_table.h"
#include "viewer/app.h"

namespace quartic::viewer {
namespace {

// What cannot be compiled will be told, and again when it is drawn.
bool judge_prepared(App& app, const Result<bool>& prepared) {
    if (!prepared) {
        app.failure = prepared.error().message;
        return true;
    }
    return prepared.value();
}

void take_packed(App& app) {
    const Status loaded = app.renderer.load(*app.next_packed);
    app.next_packed.reset();
    if (!loaded) {
        app.failure = loaded.error().message;
        return;
    }
    app.drawn_solvers = app.material_solvers;
    redraw(app);
}

}  // namespace

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
    app.next_packed.reset();
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
    app.next_solver = solver;
}

void change_material_solver(App& app, std::uint32_t material, int solver) {
    app.material_solvers[material] = solver;
    app.packing.begin([model = app.model, solvers = app.material_solvers](const Stop&) {
        PackOptions options;
        options.material_solvers = solvers;
        return pack(model->scene, options);
    });
}

bool is_prepared(App& app, const RenderOptions& options) {
    return judge_prepared(app, app.renderer.prepare(options));
}

bool is_changing_solvers(const App& app) {
    return app.next_packed.has_value() || app.next_solver != app.solver;
}

void advance_solvers(App& app) {
    if (std::optional<Result<Packed>> packed = app.packing.take()) {
        if (*packed) {
            app.next_packed = std::move(*packed).value();
        } else {
            app.failure = packed->error().message;
        }
    }
    RenderOptions options = app.options;
    options.solver = app.next_solver;
    if (app.next_packed && judge_prepared(app, app.renderer.prepare(*app.next_packed, {}))) {
        take_packed(app);
    } else if (app.next_solver != app.solver && is_prepared(app, options)) {
        app.solver = app.next_solver;
        redraw(app);
    }
}

}  // namespace quartic::viewer
