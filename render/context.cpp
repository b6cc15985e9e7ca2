// Makes EGL contexts without a window.
#include "render/context.h"

#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <array>
#include <cstdlib>
#include <string_view>
#include <utility>
#include <vector>

namespace quartic {
namespace {

// Displays to try: Mesa without a surface, then every EGL device (NVIDIA).
std::vector<EGLDisplay> displays(ContextKind kind) {
    std::vector<EGLDisplay> found;
    const char* const text = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    const std::string_view extensions = text != nullptr ? text : "";
    if (extensions.find("EGL_EXT_platform_base") == std::string_view::npos) {
        return found;
    }
    if (kind == ContextKind::automatic &&
        extensions.find("EGL_EXT_device_enumeration") != std::string_view::npos) {
        std::array<EGLDeviceEXT, 16> devices{};
        EGLint count = 0;
        eglQueryDevicesEXT(static_cast<EGLint>(devices.size()), devices.data(), &count);
        for (EGLint i = 0; i < count; ++i) {
            const char* const name =
                eglQueryDeviceStringEXT(devices[static_cast<std::size_t>(i)], EGL_EXTENSIONS);
            if (name != nullptr &&
                std::string_view(name).find("EGL_NV_device_cuda") != std::string_view::npos) {
                found.push_back(eglGetPlatformDisplayEXT(
                    EGL_PLATFORM_DEVICE_EXT, devices[static_cast<std::size_t>(i)], nullptr));
            }
        }
    }
    if (extensions.find("EGL_MESA_platform_surfaceless") != std::string_view::npos) {
        found.push_back(
            eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr));
    }
    return found;
}

EGLContext make_context(EGLDisplay display) {
    EGLint major = 0;
    EGLint minor = 0;
    if (display == EGL_NO_DISPLAY || eglInitialize(display, &major, &minor) == EGL_FALSE ||
        eglBindAPI(EGL_OPENGL_API) == EGL_FALSE) {
        return EGL_NO_CONTEXT;
    }
    const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                 4,
                                 EGL_CONTEXT_MINOR_VERSION,
                                 5,
                                 EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                 EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                 EGL_NONE};
    EGLContext context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
    if (context != EGL_NO_CONTEXT &&
        eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) == EGL_FALSE) {
        eglDestroyContext(display, context);
        context = EGL_NO_CONTEXT;
    }
    return context;
}

// Numbers that OpenGL 4.5 alone does not promise, and the shaders need.
struct Limit {
    GLenum name;
    GLint least;
    const char* text;
};
constexpr Limit limits[] = {
    {GL_MAX_VERTEX_SHADER_STORAGE_BLOCKS, 6, "storage blocks in vertex shaders"},
    {GL_MAX_FRAGMENT_SHADER_STORAGE_BLOCKS, 3, "storage blocks in fragment shaders"},
    {GL_MAX_COMPUTE_SHADER_STORAGE_BLOCKS, 8, "storage blocks in compute shaders"},
    {GL_MAX_SHADER_STORAGE_BUFFER_BINDINGS, 12, "bindings of storage blocks"},
};

}  // namespace

Result<HeadlessContext> HeadlessContext::create(ContextKind kind) {
    if (kind == ContextKind::software) {
        ::setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
    }
    const Error none{ErrorKind::no_opengl, "",
                     "no usable OpenGL: expected a driver with OpenGL 4.5 core through EGL, found "
                     "none; install one "
                     "(Debian: libegl-mesa0 and libgl1-mesa-dri) or use --device reference"};
    if (!epoxy_has_egl()) {
        return none;
    }
    for (EGLDisplay display : displays(kind)) {
        EGLContext context = make_context(display);
        if (context == EGL_NO_CONTEXT) {
            continue;
        }
        HeadlessContext result;
        result.display_ = display;
        result.context_ = context;
        const Status usable = check_context();
        if (usable) {
            return result;
        }
    }
    return none;
}

HeadlessContext::HeadlessContext(HeadlessContext&& other) noexcept
    : display_(std::exchange(other.display_, nullptr)),
      context_(std::exchange(other.context_, nullptr)) {}

HeadlessContext::~HeadlessContext() {
    if (context_ != nullptr) {
        eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        eglDestroyContext(display_, context_);
    }
}

RendererName renderer_name() {
    const auto text = [](GLenum what) {
        const GLubyte* const found = glGetString(what);
        return std::string(found != nullptr ? reinterpret_cast<const char*>(found) : "");
    };
    RendererName name{text(GL_RENDERER), text(GL_VERSION), false};
    for (const std::string_view software : {"llvmpipe", "softpipe", "SWR", "SwiftShader"}) {
        name.software = name.software || name.renderer.find(software) != std::string::npos;
    }
    return name;
}

Status check_context() {
    const auto lacks = [](const std::string& what) {
        return Error{ErrorKind::no_opengl, "",
                     "no usable OpenGL: expected " + what + ", found " + renderer_name().renderer +
                         " " + renderer_name().version + "; update the driver or use --software"};
    };
    if (epoxy_gl_version() < 45) {
        return lacks("version 4.5");
    }
    if (!epoxy_has_gl_extension("GL_ARB_shader_draw_parameters")) {
        return lacks("GL_ARB_shader_draw_parameters");
    }
    for (const Limit& limit : limits) {
        GLint value = 0;
        glGetIntegerv(limit.name, &value);
        if (value < limit.least) {
            return lacks(std::to_string(limit.least) + " " + limit.text);
        }
    }
    return Done{};
}

}  // namespace quartic
