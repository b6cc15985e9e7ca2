// Draws a scene with OpenGL 4.5: every shape solved in its fragment shader. Needs a current
// context.
#pragma once

#include "diagnostics/result.h"
#include "scene/compare.h"
#include "scene/gpu_layout.h"
#include "scene/pack.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace quartic {

// What is rasterised to start the rays of a part.
enum class Proxy : std::uint32_t {
    automatic = gpu::proxy_automatic,  // by apparent size
    box = gpu::proxy_box,              // its own box, as de Toledo, Levy, Paul 2007 draw it
    quad = gpu::proxy_quad,            // four edges in the picture that touch it
    hull = gpu::proxy_hull,            // rings of eight corners around it
};

struct RenderOptions {
    std::array<bool, layer_count> layers{true, true, true, false};
    bool cull_frustum = true;
    bool cull_size = true;
    double size_min_px = 0.3;  // parts that appear smaller are not drawn (cull_size)
    bool edges = true;
    bool occlusion = true;  // ambient occlusion
    bool lighting = true;   // without it colours are left as they are: for benchmarks of rays
    Proxy proxy = Proxy::automatic;
    bool transparent_background = false;
    std::uint32_t selected = no_index;  // part drawn highlighted
    glm::dvec2 jitter_px{0.0};          // moves all rays by a part of a pixel, for antialiasing
    // Draws what has a choice of solvers by this one, whatever it was packed for; 0: as it was.
    int solver = 0;
    bool opaque = false;   // translucent parts too: everything has an id and a depth
    bool inspect = false;  // records what the rays cost: the same picture, slower
};

// What the last frame did; read back after it, outside of any timing.
struct FrameCounts {
    std::uint64_t drawn = 0;
    std::uint64_t culled_by_frustum = 0;
    std::uint64_t culled_by_size = 0;
};

// A picture, rows from the bottom up, as it stands in GL.
struct GBuffer {
    PixelSize size;
    std::vector<std::uint32_t> ids;     // part, or no_index for the background
    std::vector<float> depth_m;         // view depth; infinity for the background
    std::vector<glm::vec3> normals;     // world, out of the solid
    std::vector<std::uint8_t> colours;  // RGBA, sRGB, straight alpha
    std::uint64_t nan_pixels = 0;       // not a number in any target

    // Of draws that inspect, else empty. Rays are those that fragments solved, hits and misses,
    // also of surfaces that a nearer one then hid; meshes and facets of polyhedra have none.
    std::vector<std::uint16_t> steps;       // of the solvers, over all rays of the pixel
    std::vector<std::uint16_t> rays;        // solved in the pixel
    std::vector<glm::vec4> ray_origins;     // the last ray, local to its part: origin, first
    std::vector<glm::vec4> ray_directions;  // direction, and t, or -1e18 where the ray missed
    std::vector<float> ray_pixels;          // Ray::pixel
};

// What the oracle can judge of it; valid as long as the buffer is.
Picture picture_of(const GBuffer& buffer);

class Renderer {
public:
    // Compiles the programs that every scene needs.
    static Result<Renderer> create();

    Renderer(Renderer&&) noexcept;
    Renderer& operator=(Renderer&&) noexcept;
    ~Renderer();

    // Uploads a packed scene, replacing the one before, and compiles its (shape, solver) programs.
    Status load(const Packed& packed);

    // Compiles at most one program that drawing like this needs, of the loaded scene or of one that
    // is to be loaded, and tells whether all are there: for a window that must stay live.
    Result<bool> prepare(const RenderOptions& options);
    Result<bool> prepare(const Packed& packed, const RenderOptions& options);

    // Draws into the renderer's own targets of this size.
    Status draw(const Camera& camera, PixelSize size, const RenderOptions& options);

    // Waits until the GPU has done all that was asked of it.
    void finish();

    // Copies the finished colours of the last draw into a framebuffer (0: the window).
    void present(unsigned framebuffer, PixelSize window_size);

    // Read from the last draw. y counts from the bottom.
    std::uint32_t part_at(int x, int y);
    std::optional<double> depth_at(int x, int y);  // metres; nothing at the background
    GBuffer read();
    FrameCounts counts();
    std::uint64_t gpu_bytes() const;

    // GL errors seen since the start; texts of the first ones.
    const std::vector<std::string>& gl_errors() const;

private:
    struct State;
    explicit Renderer(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

}  // namespace quartic
