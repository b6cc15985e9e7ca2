// Compiles shaders.
#include "render/program.h"

#include <initializer_list>

namespace quartic {
namespace {

struct Stage {
    GLenum type;
    const std::string& text;
};

std::string first_lines(std::string log) {
    constexpr std::size_t length_max = 400;
    log.resize(std::min(log.size(), length_max));
    for (char& c : log) {
        c = c == '\n' ? ' ' : c;
    }
    return log;
}

Error failure(const std::string& name, const std::string& log) {
    return {ErrorKind::no_opengl, name, "the driver refuses a shader: " + first_lines(log)};
}

Result<GlProgram> link(std::initializer_list<Stage> stages, const std::string& name) {
    GlProgram program(glCreateProgram());
    for (const Stage& stage : stages) {
        const GLuint shader = glCreateShader(stage.type);
        const char* const text = stage.text.c_str();
        glShaderSource(shader, 1, &text, nullptr);
        glCompileShader(shader);
        GLint compiled = GL_FALSE;
        glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
        std::string log(4096, '\0');
        GLsizei length = 0;
        glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), &length, log.data());
        log.resize(static_cast<std::size_t>(length));
        glAttachShader(program.name(), shader);
        glDeleteShader(shader);
        if (compiled == GL_FALSE) {
            return failure(name, log);
        }
    }
    glLinkProgram(program.name());
    GLint linked = GL_FALSE;
    glGetProgramiv(program.name(), GL_LINK_STATUS, &linked);
    if (linked == GL_FALSE) {
        std::string log(4096, '\0');
        GLsizei length = 0;
        glGetProgramInfoLog(program.name(), static_cast<GLsizei>(log.size()), &length, log.data());
        log.resize(static_cast<std::size_t>(length));
        return failure(name, log);
    }
    return program;
}

}  // namespace

Result<GlProgram> make_program(const ProgramText& text, const std::string& name) {
    return link({{GL_VERTEX_SHADER, text.vertex}, {GL_FRAGMENT_SHADER, text.fragment}}, name);
}

Result<GlProgram> make_compute_program(const std::string& text, const std::string& name) {
    return link({{GL_COMPUTE_SHADER, text}}, name);
}

}  // namespace quartic
