// SPDX-License-Identifier: MIT
#pragma once

#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <stdexcept>
#include <string>

/// Makes an OpenGL 4.3 context without a window current, once for all tests.
inline void make_context() {
    static const bool made = [] {
        if (!epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless"))
            throw std::runtime_error("EGL_MESA_platform_surfaceless is missing: install Mesa's EGL");
        const EGLDisplay display =
            eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
        const EGLint wanted[] = {EGL_CONTEXT_MAJOR_VERSION, 4, EGL_CONTEXT_MINOR_VERSION, 3, EGL_NONE};
        if (!eglInitialize(display, nullptr, nullptr) || !eglBindAPI(EGL_OPENGL_API))
            throw std::runtime_error("EGL has no OpenGL: install a driver, such as Mesa llvmpipe");
        const EGLContext context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, wanted);
        if (context == EGL_NO_CONTEXT || !eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context))
            throw std::runtime_error(
                "there is no OpenGL 4.3: install a driver that has it, such as Mesa llvmpipe");
        return true;
    }();
    static_cast<void>(made);
}

/// @throws std::runtime_error  where OpenGL has refused a call since the last one
inline void check_errors(const std::string& after) {
    if (const GLenum code = glGetError(); code != GL_NO_ERROR)
        throw std::runtime_error("OpenGL error " + std::to_string(code) + " after " + after);
}
