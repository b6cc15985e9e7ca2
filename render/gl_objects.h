// Owners of OpenGL objects, and buffers filled once.
#pragma once

#include <epoxy/gl.h>

#include <cstddef>
#include <span>
#include <utility>

namespace quartic {

// Owns one OpenGL name; Delete(name) frees it. The context must be current then.
template <auto Delete>
class GlObject {
public:
    GlObject() = default;
    explicit GlObject(GLuint name) : name_(name) {}
    GlObject(GlObject&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
    GlObject& operator=(GlObject&& other) noexcept {
        std::swap(name_, other.name_);
        return *this;
    }
    ~GlObject() {
        if (name_ != 0) {
            Delete(name_);
        }
    }
    GLuint name() const { return name_; }
    explicit operator bool() const { return name_ != 0; }

private:
    GLuint name_ = 0;
};

void delete_buffer(GLuint name);
void delete_texture(GLuint name);
void delete_framebuffer(GLuint name);
void delete_vertex_array(GLuint name);
void delete_program(GLuint name);

using GlBuffer = GlObject<delete_buffer>;
using GlTexture = GlObject<delete_texture>;
using GlFramebuffer = GlObject<delete_framebuffer>;
using GlVertexArray = GlObject<delete_vertex_array>;
using GlProgram = GlObject<delete_program>;

// A buffer of at least 16 bytes (bindings must not be empty) holding these bytes.
GlBuffer make_buffer(std::span<const std::byte> bytes, GLbitfield flags = 0);
GlBuffer make_empty_buffer(std::size_t bytes, GLbitfield flags = 0);
GlTexture make_texture(GLenum format, int width, int height);
GlVertexArray make_vertex_array();

}  // namespace quartic
