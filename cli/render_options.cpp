// The options of the verb render, and what must hold among them.
#include "cli/arguments.h"
#include "cli/render.h"
#include "files/output.h"

namespace quartic::cli {
namespace {

// Maps and halves are drawn by OpenGL, from shapes that are solved.
Status check_maps(const RenderArguments& arguments) {
    const bool is_map = !arguments.map.empty();
    const std::string option = is_map ? "--map" : "--split";
    if (!is_map && arguments.split.empty()) {
        return Done{};
    }
    if (arguments.device != "gpu" || arguments.mode != "raycast") {
        return Error{ErrorKind::usage, option,
                     "expected a picture of the GPU's rays; leave --device and --mode out"};
    }
    if (arguments.frames > 0) {
        return Error{ErrorKind::usage, option,
                     "expected a picture to be looked at, not timed; leave --frames out"};
    }
    if (is_map && arguments.samples > 1) {
        return Error{ErrorKind::usage, option,
                     "expected one ray for each pixel of a map; leave --samples out"};
    }
    if (arguments.map == row_of(MapKind::difference).name && !arguments.split.empty()) {
        return Error{ErrorKind::usage, option,
                     "a difference shows two solvers already; leave --split out"};
    }
    return Done{};
}

// Finds out before the work whether its results can be written.
Status check_outputs(const RenderArguments& arguments) {
    for (const std::string& path :
         {arguments.output, arguments.depth, arguments.ids, arguments.normals}) {
        if (path.empty()) {
            continue;
        }
        if (path == "-" && arguments.reporting.json) {
            return Error{ErrorKind::usage, "-o -",
                         "standard output cannot hold both the picture and --json; name a file"};
        }
        const std::string_view ending = path == arguments.depth ? ".exr" : ".png";
        if (path != "-" && !path.ends_with(ending)) {
            return Error{ErrorKind::usage, path,
                         "expected a name that ends in " + std::string(ending) +
                             ", the format that is written"};
        }
        const Result<Output> output = Output::create(path);
        if (!output) {
            return output.error();
        }
    }
    return Done{};
}

void add_outputs(CLI::App& verb, RenderArguments& arguments) {
    verb.add_option("-o,--output", arguments.output, "the picture, PNG; - is standard output")
        ->required();
    verb.add_option("--depth", arguments.depth, "depth in metres, OpenEXR, one float channel Z");
    verb.add_option("--ids", arguments.ids, "part numbers, PNG: red is the highest byte");
    verb.add_option("--normals", arguments.normals, "world normals, PNG");
    verb.add_option("--frames", arguments.frames, "draw so many frames more and time them")
        ->check(CLI::Range(0, 100000));
}

void add_looks(CLI::App& verb, RenderArguments& arguments) {
    verb.add_option("--size", arguments.size, "WxH in pixels")->check(check_size);
    verb.add_option("--camera", arguments.camera,
                    "fit, iso, front, back, left, right, top, bottom or "
                    "\"ex,ey,ez;tx,ty,tz;ux,uy,uz\" (eye, target, up)");
    verb.add_option("--projection", arguments.projection, "perspective or orthographic")
        ->check(CLI::IsMember({"perspective", "orthographic"}));
    verb.add_option("--fov", arguments.fov_deg, "height of a perspective view, degrees")
        ->check(CLI::Range(1.0, 170.0));
    verb.add_option("--samples", arguments.samples, "draws that are averaged, against jagged edges")
        ->check(CLI::Range(1, 1024));
    verb.add_option("--show", arguments.shown, "a layer: normal, obstruction, insulation, lines")
        ->check(check_layer)
        ->expected(1)
        ->take_all()
        ->default_str("");
    verb.add_option("--hide", arguments.hidden, "a layer; lines are hidden unless shown")
        ->check(check_layer)
        ->expected(1)
        ->take_all()
        ->default_str("");
    verb.add_flag("--transparent", arguments.transparent, "leave the background out");
}

void add_maps(CLI::App& verb, RenderArguments& arguments) {
    std::vector<std::string> names;
    for (const MapRow& row : map_table()) {
        names.emplace_back(row.name);
    }
    verb.add_option("--map", arguments.map,
                    "draw what the solvers did: steps, rays, error, solver or difference")
        ->check(CLI::IsMember(names))
        ->default_str("");
    verb.add_option("--against", arguments.against, "the second solver of --map difference")
        ->check(check_solver);
    verb.add_option("--split", arguments.split, "draw the right half of the picture by this solver")
        ->check(check_solver);
}

void add_methods(CLI::App& verb, RenderArguments& arguments) {
    add_solvers(verb, arguments.solvers);
    verb.add_option("--device", arguments.device, "gpu, or reference: the CPU in double precision")
        ->check(CLI::IsMember({"gpu", "reference"}));
    verb.add_flag("--software", arguments.software, "Mesa's software OpenGL");
    verb.add_option("--mode", arguments.mode, "raycast, or tessellated: shapes become triangles")
        ->check(CLI::IsMember({"raycast", "tessellated"}));
    verb.add_option("--tolerance", arguments.tolerance_mm,
                    "how far triangles may depart from the shapes, mm")
        ->check(CLI::Range(1e-3, 1e6));
}

}  // namespace

void add_render_options(CLI::App& verb, RenderArguments& arguments) {
    add_outputs(verb, arguments);
    add_looks(verb, arguments);
    add_maps(verb, arguments);
    add_methods(verb, arguments);
    add_reporting(verb, arguments.reporting);
}

Status check_render(const RenderArguments& arguments) {
    const Status sensible = check_maps(arguments);
    return sensible ? check_outputs(arguments) : sensible;
}

RenderOptions render_options(const RenderArguments& arguments) {
    RenderOptions options;
    options.layers = chosen_layers(arguments.shown, arguments.hidden);
    options.transparent_background = arguments.transparent;
    return options;
}

}  // namespace quartic::cli
