// Makes and frees OpenGL objects.
#include "render/gl_objects.h"

#include <algorithm>

namespace quartic {

void delete_buffer(GLuint name) {
    glDeleteBuffers(1, &name);
}

void delete_texture(GLuint name) {
    glDeleteTextures(1, &name);
}

void delete_framebuffer(GLuint name) {
    glDeleteFramebuffers(1, &name);
}

void delete_vertex_array(GLuint name) {
    glDeleteVertexArrays(1, &name);
}

void delete_program(GLuint name) {
    glDeleteProgram(name);
}

GlBuffer make_buffer(std::span<const std::byte> bytes, GLbitfield flags) {
    if (bytes.size() < 16) {
        GlBuffer buffer = make_empty_buffer(16, flags | GL_DYNAMIC_STORAGE_BIT);
        glNamedBufferSubData(buffer.name(), 0, static_cast<GLsizeiptr>(bytes.size()), bytes.data());
        return buffer;
    }
    GLuint name = 0;
    glCreateBuffers(1, &name);
    glNamedBufferStorage(name, static_cast<GLsizeiptr>(bytes.size()), bytes.data(), flags);
    return GlBuffer(name);
}

GlBuffer make_empty_buffer(std::size_t bytes, GLbitfield flags) {
    GLuint name = 0;
    glCreateBuffers(1, &name);
    glNamedBufferStorage(name, static_cast<GLsizeiptr>(std::max<std::size_t>(bytes, 16)), nullptr,
                         flags);
    return GlBuffer(name);
}

GlTexture make_texture(GLenum format, int width, int height) {
    GLuint name = 0;
    glCreateTextures(GL_TEXTURE_2D, 1, &name);
    glTextureStorage2D(name, 1, format, width, height);
    glTextureParameteri(name, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTextureParameteri(name, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    return GlTexture(name);
}

GlVertexArray make_vertex_array() {
    GLuint name = 0;
    glCreateVertexArrays(1, &name);
    return GlVertexArray(name);
}

}  // namespace quartic
