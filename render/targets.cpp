// Makes a frame's pictures.
#include "render/targets.h"

#include "diagnostics/check.h"
#include "scene/gpu_layout.h"

#include <initializer_list>
#include <vector>

namespace quartic {
namespace {

GlFramebuffer make_framebuffer(std::initializer_list<GLuint> colours, GLuint depth) {
    GLuint name = 0;
    glCreateFramebuffers(1, &name);
    std::vector<GLenum> buffers;
    for (const GLuint colour : colours) {
        const GLenum attachment = GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(buffers.size());
        glNamedFramebufferTexture(name, attachment, colour, 0);
        buffers.push_back(attachment);
    }
    if (depth != 0) {
        glNamedFramebufferTexture(name, GL_DEPTH_ATTACHMENT, depth, 0);
    }
    glNamedFramebufferDrawBuffers(name, static_cast<GLsizei>(buffers.size()), buffers.data());
    CHECK(glCheckNamedFramebufferStatus(name, GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE);
    return GlFramebuffer(name);
}

}  // namespace

Targets make_targets(PixelSize size) {
    Targets targets;
    targets.size = size;
    targets.parts = make_texture(GL_R32UI, size.width, size.height);
    targets.normals = make_texture(GL_R32UI, size.width, size.height);
    targets.depth = make_texture(GL_DEPTH_COMPONENT32F, size.width, size.height);
    targets.translucent = make_texture(GL_RGBA16F, size.width, size.height);
    targets.revealed = make_texture(GL_R16F, size.width, size.height);
    targets.colours = make_texture(GL_RGBA8, size.width, size.height);
    targets.surfaces =
        make_framebuffer({targets.parts.name(), targets.normals.name()}, targets.depth.name());
    targets.blending = make_framebuffer({targets.translucent.name(), targets.revealed.name()},
                                        targets.depth.name());
    targets.finished = make_framebuffer({targets.colours.name()}, 0);
    return targets;
}

InspectionTargets make_inspection_targets(PixelSize size) {
    InspectionTargets targets;
    targets.size = size;
    targets.counts = make_texture(GL_R32UI, size.width, size.height);
    targets.ray_origins = make_texture(GL_RGBA32F, size.width, size.height);
    targets.ray_directions = make_texture(GL_RGBA32F, size.width, size.height);
    targets.ray_pixels = make_texture(GL_R32F, size.width, size.height);
    return targets;
}

void begin_inspection(const InspectionTargets& targets) {
    glClearTexImage(targets.counts.name(), 0, GL_RED_INTEGER, GL_UNSIGNED_INT, nullptr);
    for (const GlTexture* texture : {&targets.ray_origins, &targets.ray_directions}) {
        glClearTexImage(texture->name(), 0, GL_RGBA, GL_FLOAT, nullptr);
    }
    glClearTexImage(targets.ray_pixels.name(), 0, GL_RED, GL_FLOAT, nullptr);
    const auto bind = [](int unit, const GlTexture& texture, GLenum access, GLenum format) {
        glBindImageTexture(static_cast<GLuint>(unit), texture.name(), 0, GL_FALSE, 0, access,
                           format);
    };
    bind(gpu::image_counts, targets.counts, GL_READ_WRITE, GL_R32UI);
    bind(gpu::image_ray_origins, targets.ray_origins, GL_WRITE_ONLY, GL_RGBA32F);
    bind(gpu::image_ray_directions, targets.ray_directions, GL_WRITE_ONLY, GL_RGBA32F);
    bind(gpu::image_ray_pixels, targets.ray_pixels, GL_WRITE_ONLY, GL_R32F);
}

}  // namespace quartic
