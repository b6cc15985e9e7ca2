// The passes of a frame, in their order.
#include "render/frame.h"

#include "scene/gpu_layout.h"
#include "shaders/variants.h"

namespace quartic {
namespace {

void bind_storage(int binding, const GlBuffer& buffer) {
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, static_cast<GLuint>(binding), buffer.name());
}

GLuint groups_of(std::size_t threads) {
    constexpr std::size_t group_threads = 64;  // local_size_x of the shaders
    return static_cast<GLuint>((threads + group_threads - 1) / group_threads);
}

void bind_culling(const SceneBuffers& scene) {
    bind_storage(gpu::binding_visible, scene.visible);
    bind_storage(gpu::binding_near, scene.near_parts);
    bind_storage(gpu::binding_commands, scene.commands);
    bind_storage(gpu::binding_batches, scene.batches);
    bind_storage(gpu::binding_counts, scene.counts);
    bind_storage(gpu::binding_decisions, scene.decisions);
    bind_storage(gpu::binding_table, scene.table);
}

void cull(const SceneBuffers& scene, const std::array<GlProgram, 3>& programs, Proxy proxy) {
    const GlBuffer& empty = proxy == Proxy::box ? scene.box_commands : scene.empty_commands;
    glCopyNamedBufferSubData(empty.name(), scene.commands.name(), 0, 0,
                             static_cast<GLsizeiptr>(scene.command_count * sizeof(gpu::Command)));
    for (const GlBuffer* buffer : {&scene.counts, &scene.table}) {
        glClearNamedBufferData(buffer->name(), GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, nullptr);
    }
    bind_culling(scene);
    glUseProgram(programs[0].name());
    for (const BoundsPage& page : scene.pages) {
        glBindBufferRange(GL_SHADER_STORAGE_BUFFER, gpu::binding_bounds, scene.bounds.name(),
                          static_cast<GLintptr>(page.first_bounds * sizeof(gpu::BoundsBlock)),
                          static_cast<GLsizeiptr>(page.bounds_count * sizeof(gpu::BoundsBlock)));
        glUniform1ui(0, page.first_chunk);
        glUniform1ui(1, page.first_bounds);
        glDispatchCompute(page.chunk_count, 1, 1);
    }
    if (scene.chunk_count > 0) {
        glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
        glUseProgram(programs[1].name());
        glUniform1ui(0, scene.chunk_count);
        glDispatchCompute(groups_of(scene.draws.size() * gpu::commands_per_batch), 1, 1);
        glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
        glUseProgram(programs[2].name());
        glUniform1ui(0, scene.chunk_count);
        glDispatchCompute(groups_of(scene.chunk_count), 1, 1);
    }
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT);
}

const void* command_offset(std::uint32_t command) {
    return reinterpret_cast<const void*>(std::size_t{command} * sizeof(gpu::Command));
}

// One command of every batch of shapes.
void draw_shapes(const SceneBuffers& scene, bool transparent, Pass pass) {
    for (std::size_t i = 0; i < scene.draws.size(); ++i) {
        const DrawBatch& batch = scene.draws[i];
        const GLuint program = batch.programs[static_cast<std::size_t>(pass)];
        if (batch.transparent != transparent || batch.type == ShapeType::mesh || program == 0) {
            continue;
        }
        glUseProgram(program);
        glUniform1ui(0, static_cast<GLuint>(i));
        bind_storage(gpu::binding_records, batch.records);
        glDrawElementsIndirect(
            GL_TRIANGLES, GL_UNSIGNED_SHORT,
            command_offset(batch.first_command + static_cast<std::uint32_t>(pass)));
    }
}

void draw_meshes(const SceneBuffers& scene, bool transparent) {
    glDisable(GL_CULL_FACE);
    glBindVertexArray(scene.mesh_array.name());
    for (const DrawBatch& batch : scene.draws) {
        if (batch.transparent != transparent || batch.type != ShapeType::mesh) {
            continue;
        }
        glUseProgram(batch.programs[0]);
        bind_storage(gpu::binding_records, batch.records);
        glMultiDrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_INT,
                                    command_offset(batch.first_command),
                                    static_cast<GLsizei>(batch.count), sizeof(gpu::Command));
    }
}

void draw_parts(const SceneBuffers& scene, bool transparent) {
    glBindVertexArray(scene.proxy_array.name());
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, scene.commands.name());
    glEnable(GL_CULL_FACE);
    glCullFace(GL_BACK);
    draw_shapes(scene, transparent, Pass::small);
    draw_shapes(scene, transparent, Pass::large);
    // Where the near plane cuts or the eye is inside, the boxes' far faces cover the parts.
    glCullFace(GL_FRONT);
    draw_shapes(scene, transparent, Pass::near);
    draw_meshes(scene, transparent);
}

void clear(const Targets& targets, bool has_translucent) {
    const GLuint no_part[4] = {gpu::no_part, 0, 0, 0};
    const GLuint no_normal[4] = {};
    const float farthest = 0.0f;
    const float nothing[4] = {};
    const float all_revealed[4] = {1.0f, 0.0f, 0.0f, 0.0f};
    glClearNamedFramebufferuiv(targets.surfaces.name(), GL_COLOR, 0, no_part);
    glClearNamedFramebufferuiv(targets.surfaces.name(), GL_COLOR, 1, no_normal);
    glClearNamedFramebufferfv(targets.surfaces.name(), GL_DEPTH, 0, &farthest);
    if (has_translucent) {
        glClearNamedFramebufferfv(targets.blending.name(), GL_COLOR, 0, nothing);
        glClearNamedFramebufferfv(targets.blending.name(), GL_COLOR, 1, all_revealed);
    }
}

void draw_surfaces(const SceneBuffers& scene, const Targets& targets) {
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, targets.surfaces.name());
    draw_parts(scene, false);
}

void draw_translucent(const SceneBuffers& scene, const Targets& targets) {
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, targets.blending.name());
    glDepthMask(GL_FALSE);
    glEnable(GL_BLEND);
    glBlendFunci(0, GL_ONE, GL_ONE);
    glBlendFunci(1, GL_ZERO, GL_ONE_MINUS_SRC_COLOR);
    draw_parts(scene, true);
    glDisable(GL_BLEND);
    glDepthMask(GL_TRUE);
}

void resolve(const SceneBuffers& scene, const Targets& targets, const GlProgram& program,
             bool see_through) {
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, targets.finished.name());
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glUseProgram(program.name());
    glUniform1i(0, see_through ? 1 : 0);
    glUniform1i(1, scene.has_translucent ? 1 : 0);
    const GLuint pictures[] = {targets.parts.name(), targets.normals.name(), targets.depth.name(),
                               targets.translucent.name(), targets.revealed.name()};
    glBindTextures(0, 5, pictures);
    glBindVertexArray(scene.proxy_array.name());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindTextures(0, 5, nullptr);
}

}  // namespace

void draw_frame(const SceneBuffers& scene, const Targets& targets, const FramePrograms& programs,
                GLuint camera, FrameOptions options) {
    glViewport(0, 0, targets.size.width, targets.size.height);
    glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    glDepthFunc(GL_GREATER);
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_TRUE);
    glBindBufferBase(GL_UNIFORM_BUFFER, gpu::binding_camera, camera);
    bind_storage(gpu::binding_chunks, scene.chunks);
    bind_storage(gpu::binding_part_materials, scene.part_materials);
    bind_storage(gpu::binding_materials, scene.materials);

    cull(scene, programs.cull, options.proxy);
    clear(targets, scene.has_translucent);
    draw_surfaces(scene, targets);
    if (scene.has_translucent) {
        draw_translucent(scene, targets);
    }
    if (options.lighting) {
        resolve(scene, targets, programs.resolve, options.transparent_background);
    }
}

}  // namespace quartic
