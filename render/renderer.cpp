// The renderer: owns programs, buffers and targets, draws frames and reads them back.
#include "render/renderer.h"

#include "diagnostics/check.h"
#include "render/frame.h"
#include "render/program.h"
#include "scene/gpu_layout.h"
#include "solvers/solver_table.h"

#include <glm/packing.hpp>

#include <cmath>
#include <limits>

namespace quartic {
namespace {

constexpr std::size_t gl_errors_max = 16;
constexpr std::size_t inspected_pixels_max = 0x7fffffff / sizeof(glm::vec4);  // to be read at once

gpu::CameraBlock camera_block(const View& view, const RenderOptions& options) {
    gpu::CameraBlock block{};
    block.eye = glm::dvec4(view.eye, 1.0);
    block.right = glm::dvec4(view.right, 0.0);
    block.up = glm::dvec4(view.up, 0.0);
    block.back = glm::dvec4(view.back, 0.0);
    block.step = view.step;
    block.near_depth = view.near_m;
    block.far_depth = view.far_m;
    block.focus_depth = view.focus_m;
    block.half_width = 0.5 * view.size.width;
    block.half_height = 0.5 * view.size.height;
    block.jitter_x = options.jitter_px.x;
    block.jitter_y = options.jitter_px.y;
    block.orthographic = view.projection == Projection::orthographic ? 1 : 0;
    block.size_min_px = options.cull_size ? static_cast<float>(options.size_min_px) : 0.0f;
    for (std::size_t i = 0; i < layer_count; ++i) {
        block.layer_mask |= options.layers[i] ? 1u << i : 0u;
    }
    block.cull_frustum = options.cull_frustum ? 1u : 0u;
    block.height = static_cast<float>(2.0 * block.half_height * view.step);
    block.near_from_focus = static_cast<float>(view.near_m - view.focus_m);
    block.near_from_eye = static_cast<float>(view.near_m);
    block.proxy = static_cast<std::uint32_t>(options.proxy);
    block.selected = options.selected;
    block.edges = options.edges ? 1u : 0u;
    block.occlusion = options.occlusion ? 1u : 0u;
    return block;
}

// What of the options the programs depend on.
struct Looks {
    int solver = 0;
    bool opaque = false;
    bool inspect = false;
    bool operator==(const Looks&) const = default;
};

// A target's normal; its two halves are what GLSL calls snorm.
glm::vec3 normal_from(std::uint32_t bits) {
    return gpu::Picture<float>().normal_from_octahedron(glm::unpackSnorm2x16(bits));
}

void read_inspection(const InspectionTargets& targets, GBuffer& picture) {
    const std::size_t pixels = picture.ids.size();
    const auto bytes = static_cast<GLsizei>(sizeof(glm::vec4) * pixels);
    picture.ray_origins.resize(pixels);
    picture.ray_directions.resize(pixels);
    glGetTextureImage(targets.ray_origins.name(), 0, GL_RGBA, GL_FLOAT, bytes,
                      picture.ray_origins.data());
    glGetTextureImage(targets.ray_directions.name(), 0, GL_RGBA, GL_FLOAT, bytes,
                      picture.ray_directions.data());
    picture.ray_pixels.resize(pixels);
    glGetTextureImage(targets.ray_pixels.name(), 0, GL_RED, GL_FLOAT,
                      static_cast<GLsizei>(4 * pixels), picture.ray_pixels.data());
    std::vector<std::uint32_t> counts(pixels);
    glGetTextureImage(targets.counts.name(), 0, GL_RED_INTEGER, GL_UNSIGNED_INT,
                      static_cast<GLsizei>(4 * pixels), counts.data());
    constexpr std::uint32_t steps_mask = (1u << gpu::ray_shift) - 1;
    for (const std::uint32_t count : counts) {
        picture.steps.push_back(static_cast<std::uint16_t>(std::min(count & steps_mask, 0xffffu)));
        picture.rays.push_back(static_cast<std::uint16_t>(count >> gpu::ray_shift));
    }
}

ProgramKey key_of(const PrimitiveVariant& variant) {
    return {static_cast<int>(variant.type),
            variant.solver,
            variant.form,
            variant.hull_rings,
            variant.transparent,
            static_cast<int>(variant.pass),
            variant.inspect};
}

std::span<const Pass> passes_of(ShapeType type) {
    static constexpr Pass one[] = {Pass::small};
    static constexpr Pass of_polyhedra[] = {Pass::small, Pass::near};
    static constexpr Pass all[] = {Pass::small, Pass::large, Pass::near};
    if (type == ShapeType::mesh) {
        return one;
    }
    return is_polyhedron(type) ? std::span<const Pass>(of_polyhedra) : all;
}

std::vector<PrimitiveVariant> variants_of(const Packed& packed) {
    std::vector<PrimitiveVariant> variants;
    for (const Batch& batch : packed.batches) {
        variants.push_back({.type = batch.type,
                            .solver = batch.solver,
                            .form = batch.form,
                            .hull_rings = batch.hull_rings,
                            .transparent = batch.transparent});
    }
    return variants;
}

Looks looks_of(const RenderOptions& options) {
    return {options.solver, options.opaque, options.inspect};
}

// A batch's variant as the looks and the pass have it.
PrimitiveVariant seen_as(PrimitiveVariant variant, const Looks& looks, Pass pass) {
    variant.pass = pass;
    variant.transparent = variant.transparent && !looks.opaque;
    variant.inspect = looks.inspect && casts_rays(variant);
    if (looks.solver != 0) {
        variant.solver = solver_for(name(variant.type), looks.solver);
    }
    return variant;
}

}  // namespace

struct Renderer::State {
    Proxies proxies;
    FramePrograms programs;
    SceneBuffers scene;
    Targets targets;
    InspectionTargets inspection;
    std::vector<PrimitiveVariant> variants;  // of the scene's draws, as they were packed
    Looks looks;                             // what the draws' programs are made for
    GlBuffer camera;
    View view{};
    Box3 box;  // of all parts
    std::vector<std::string> gl_errors;

    void collect_errors(const char* where) {
        for (GLenum error = glGetError(); error != GL_NO_ERROR && gl_errors.size() < gl_errors_max;
             error = glGetError()) {
            gl_errors.push_back(std::string(where) + ": GL error " + std::to_string(error));
        }
    }

    Result<GLuint> program_of(const PrimitiveVariant& variant) {
        const ProgramKey key = key_of(variant);
        const auto known = scene.programs.find(key);
        if (known != scene.programs.end()) {
            return known->second.name();
        }
        Result<GlProgram> program =
            make_program(program_text(variant), std::string(name(variant.type)));
        if (!program) {
            return program.error();
        }
        const GLuint made = program.value().name();
        scene.programs[key] = std::move(program).value();
        return made;
    }

    // Gives every draw its programs; those that are new are compiled, and all are kept.
    Status choose_programs(const Looks& wanted) {
        looks = wanted;
        scene.has_translucent = false;
        for (std::size_t i = 0; i < variants.size(); ++i) {
            DrawBatch& draw = scene.draws[i];
            draw.transparent = variants[i].transparent && !looks.opaque;
            scene.has_translucent = scene.has_translucent || draw.transparent;
            for (const Pass pass : passes_of(variants[i].type)) {
                const Result<GLuint> program = program_of(seen_as(variants[i], looks, pass));
                if (!program) {
                    return program.error();
                }
                draw.programs[static_cast<std::size_t>(pass)] = program.value();
            }
        }
        return Done{};
    }

    // Compiles the first program that is missing, and tells whether none is.
    Result<bool> prepare(std::span<const PrimitiveVariant> packed, const Looks& wanted) {
        for (const PrimitiveVariant& variant : packed) {
            for (const Pass pass : passes_of(variant.type)) {
                const PrimitiveVariant seen = seen_as(variant, wanted, pass);
                if (scene.programs.contains(key_of(seen))) {
                    continue;
                }
                const Result<GLuint> made = program_of(seen);
                return made ? Result<bool>(false) : made.error();
            }
        }
        return true;
    }
};

Picture picture_of(const GBuffer& buffer) {
    return {buffer.size, buffer.ids, buffer.depth_m, buffer.normals};
}

Renderer::Renderer(std::unique_ptr<State> state) : state_(std::move(state)) {}
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;
Renderer::~Renderer() = default;

Result<Renderer> Renderer::create() {
    auto state = std::make_unique<State>();
    std::size_t dispatch = 0;
    for (const NamedText& shader : cull_texts()) {
        Result<GlProgram> program = make_compute_program(shader.text, shader.file_name);
        if (!program) {
            return program.error();
        }
        state->programs.cull[dispatch++] = std::move(program).value();
    }
    Result<GlProgram> resolve = make_program(resolve_text(), "resolve");
    if (!resolve) {
        return resolve.error();
    }
    state->programs.resolve = std::move(resolve).value();
    state->proxies = make_proxies();
    state->camera = make_empty_buffer(sizeof(gpu::CameraBlock), GL_DYNAMIC_STORAGE_BIT);
    state->scene =
        upload(Packed{{}, {}, {}, {}, {}, {}, {}, {glm::vec4(1.0f)}, {}}, state->proxies);
    state->collect_errors("create");
    return Renderer(std::move(state));
}

Status Renderer::load(const Packed& packed) {
    SceneBuffers scene = upload(packed, state_->proxies);
    scene.programs = std::move(state_->scene.programs);
    state_->scene = std::move(scene);
    state_->box = packed.box;
    state_->variants = variants_of(packed);
    const Status chosen = state_->choose_programs({});
    if (!chosen) {
        return chosen;
    }
    if (glGetError() == GL_OUT_OF_MEMORY) {
        return Error{ErrorKind::no_opengl, "", "the scene does not fit into the GPU's memory"};
    }
    state_->collect_errors("load");
    return Done{};
}

Result<bool> Renderer::prepare(const RenderOptions& options) {
    return state_->prepare(state_->variants, looks_of(options));
}

Result<bool> Renderer::prepare(const Packed& packed, const RenderOptions& options) {
    return state_->prepare(variants_of(packed), looks_of(options));
}

Status Renderer::draw(const Camera& camera, PixelSize size, const RenderOptions& options) {
    if (size.width < 1 || size.height < 1 || size.width > 16384 || size.height > 16384) {
        return Error{ErrorKind::usage, "", "expected a picture of 1x1 to 16384x16384 pixels"};
    }
    if (state_->targets.size != size) {
        state_->targets = make_targets(size);
    }
    state_->view = make_view(camera, size);
    if (!state_->box.empty()) {
        const double farthest = depth_range(state_->box, camera.eye, -state_->view.back)[1];
        const double slack = 1e-3 * glm::length(state_->box.high - state_->box.low);
        state_->view.far_m = std::max(farthest, camera.near_m) + slack;
    }
    const gpu::CameraBlock block = camera_block(state_->view, options);
    glNamedBufferSubData(state_->camera.name(), 0, sizeof(block), &block);
    const Looks looks = looks_of(options);
    if (state_->looks != looks) {
        const Status chosen = state_->choose_programs(looks);
        if (!chosen) {
            return chosen;
        }
    }
    if (options.inspect) {
        if (pixel_count(size) > inspected_pixels_max) {
            return Error{ErrorKind::usage, "",
                         "expected at most 134 million pixels where rays are inspected"};
        }
        if (state_->inspection.size != size) {
            state_->inspection = make_inspection_targets(size);
        }
        begin_inspection(state_->inspection);
    }
    draw_frame(state_->scene, state_->targets, state_->programs, state_->camera.name(),
               {options.proxy, options.lighting, options.transparent_background});
    if (options.inspect) {
        glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT);
    }
    state_->collect_errors("draw");
    return Done{};
}

void Renderer::finish() {
    glFinish();
}

void Renderer::present(unsigned framebuffer, PixelSize window_size) {
    const PixelSize size = state_->targets.size;
    glBlitNamedFramebuffer(state_->targets.finished.name(), framebuffer, 0, 0, size.width,
                           size.height, 0, 0, window_size.width, window_size.height,
                           GL_COLOR_BUFFER_BIT, GL_NEAREST);
    state_->collect_errors("present");
}

std::uint32_t Renderer::part_at(int x, int y) {
    std::uint32_t part = no_index;
    const PixelSize size = state_->targets.size;
    if (x >= 0 && y >= 0 && x < size.width && y < size.height) {
        glGetTextureSubImage(state_->targets.parts.name(), 0, x, y, 0, 1, 1, 1, GL_RED_INTEGER,
                             GL_UNSIGNED_INT, sizeof(part), &part);
    }
    state_->collect_errors("part_at");
    return part;
}

std::optional<double> Renderer::depth_at(int x, int y) {
    float value = 0.0f;
    const PixelSize size = state_->targets.size;
    if (x >= 0 && y >= 0 && x < size.width && y < size.height) {
        glGetTextureSubImage(state_->targets.depth.name(), 0, x, y, 0, 1, 1, 1, GL_DEPTH_COMPONENT,
                             GL_FLOAT, sizeof(value), &value);
    }
    state_->collect_errors("depth_at");
    return value > 0.0f ? std::optional(depth_from_buffer(state_->view, static_cast<double>(value)))
                        : std::nullopt;
}

GBuffer Renderer::read() {
    const Targets& targets = state_->targets;
    const std::size_t pixels = pixel_count(targets.size);
    const auto bytes = static_cast<GLsizei>(4 * pixels);
    GBuffer picture;
    picture.size = targets.size;
    picture.ids.resize(pixels);
    picture.depth_m.resize(pixels);
    picture.colours.resize(4 * pixels);
    std::vector<std::uint32_t> normals(pixels);
    glGetTextureImage(targets.parts.name(), 0, GL_RED_INTEGER, GL_UNSIGNED_INT, bytes,
                      picture.ids.data());
    glGetTextureImage(targets.normals.name(), 0, GL_RED_INTEGER, GL_UNSIGNED_INT, bytes,
                      normals.data());
    glGetTextureImage(targets.depth.name(), 0, GL_DEPTH_COMPONENT, GL_FLOAT, bytes,
                      picture.depth_m.data());
    glGetTextureImage(targets.colours.name(), 0, GL_RGBA, GL_UNSIGNED_BYTE, bytes,
                      picture.colours.data());
    picture.normals.reserve(pixels);
    for (std::size_t i = 0; i < pixels; ++i) {
        float& depth = picture.depth_m[i];
        const bool empty = picture.ids[i] == no_index;
        const glm::vec3 normal = normal_from(normals[i]);
        picture.normals.push_back(normal);
        picture.nan_pixels +=
            !std::isfinite(depth) || !std::isfinite(normal.x + normal.y + normal.z);
        depth =
            empty ? std::numeric_limits<float>::infinity()
                  : static_cast<float>(depth_from_buffer(state_->view, static_cast<double>(depth)));
    }
    if (state_->looks.inspect) {
        read_inspection(state_->inspection, picture);
    }
    state_->collect_errors("read");
    return picture;
}

FrameCounts Renderer::counts() {
    gpu::CountsBlock block{};
    glGetNamedBufferSubData(state_->scene.counts.name(), 0, sizeof(block), &block);
    state_->collect_errors("counts");
    return {block.drawn, block.culled_by_frustum, block.culled_by_size};
}

std::uint64_t Renderer::gpu_bytes() const {
    return state_->scene.bytes;
}

const std::vector<std::string>& Renderer::gl_errors() const {
    return state_->gl_errors;
}

}  // namespace quartic
