// What the verb render is asked for and what it drew, shared by the files that do its parts.
#pragma once

#include "cli/report.h"
#include "cli/solvers.h"
#include "render/renderer.h"
#include "scene/map.h"

#include <optional>
#include <string>
#include <vector>

namespace quartic::cli {

struct RenderArguments {
    std::vector<std::string> files;
    std::string output;
    std::string size = "1600x1000";
    std::string camera = "iso";
    std::string projection = "perspective";
    double fov_deg = 35.0;
    SolverArguments solvers;
    std::string device = "gpu";
    std::string mode = "raycast";
    double tolerance_mm = 1.0;
    std::string depth;
    std::string ids;
    std::string normals;
    std::string map;                          // empty: a picture
    std::string against = "convexity_split";  // the other solver of a difference
    std::string split;                        // the right half's solver; empty: no halves
    int samples = 1;
    int frames = 0;
    bool software = false;
    bool transparent = false;
    std::vector<std::string> shown;
    std::vector<std::string> hidden;
    Reporting reporting;
};

void add_render_options(CLI::App& verb, RenderArguments& arguments);
// What options say to one another, and whether the results can be written: before the work.
Status check_render(const RenderArguments& arguments);

RenderOptions render_options(const RenderArguments& arguments);

// What the JSON tells of a picture, besides the picture.
struct Drawn {
    GBuffer picture;
    std::vector<std::uint8_t> colours;
    std::optional<Map> map;
    std::string renderer;
    FrameCounts counts;
    std::uint64_t gpu_bytes = 0;
    double first_frame_ms = 0.0;
    std::vector<double> frame_ms;
};

Result<Drawn> draw_on_gpu(const Scene& scene, const Camera& camera, PixelSize size,
                          const RenderArguments& arguments);
Drawn draw_on_cpu(const Scene& scene, const Camera& camera, PixelSize size,
                  const RenderArguments& arguments);

// Makes a map of the first picture, or of both, and a split picture of two; its colours replace
// those that were drawn.
void show_map(const Scene& scene, const View& view, const RenderArguments& arguments,
              const Drawn* second, Drawn& drawn);
void show_halves(const RenderArguments& arguments, const Drawn& second, Drawn& drawn);

}  // namespace quartic::cli
