// SPDX-License-Identifier: MIT
// An OpenGL renderer that runs an effect of crease as full-screen fragment passes, without a window.
#include "corner.hpp"

#include <crease/crease.hpp>

#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <span>
#include <stdexcept>
#include <string>

using ao = crease::effect<crease::directions<4, 4>, crease::single_layer, crease::hbao, crease::bilateral<>,
                          crease::reconstructed_normals, crease::fragment, crease::opengl_glsl>;

namespace {

void make_context() {
    if (!epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless"))
        throw std::runtime_error("EGL cannot work without a window system here: "
                                 "EGL_MESA_platform_surfaceless is missing; install Mesa's EGL");
    const EGLDisplay display =
        eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    const EGLint wanted[] = {EGL_CONTEXT_MAJOR_VERSION, 4, EGL_CONTEXT_MINOR_VERSION, 3, EGL_NONE};
    if (!eglInitialize(display, nullptr, nullptr) || !eglBindAPI(EGL_OPENGL_API))
        throw std::runtime_error("EGL has no OpenGL: install a driver, such as Mesa llvmpipe");
    const EGLContext context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, wanted);
    if (context == EGL_NO_CONTEXT || !eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context))
        throw std::runtime_error(
            "there is no OpenGL 4.3: install a driver that has it, such as Mesa llvmpipe");
}

void attach(GLuint program, GLenum stage, std::span<const crease::piece> pieces) {
    std::vector<const char*> texts; // the pieces are not NUL-terminated: OpenGL takes their lengths
    std::vector<GLint> lengths;
    for (const crease::piece& piece : pieces) {
        texts.push_back(piece.text.data());
        lengths.push_back(static_cast<GLint>(piece.text.size()));
    }
    const GLuint shader = glCreateShader(stage);
    glShaderSource(shader, static_cast<GLsizei>(texts.size()), texts.data(), lengths.data());
    glCompileShader(shader);
    GLint compiled = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    if (!compiled) {
        char log[4096]{};
        glGetShaderInfoLog(shader, sizeof log, nullptr, log);
        throw std::runtime_error(log);
    }
    glAttachShader(program, shader);
    glDeleteShader(shader); // lives as long as the program
}

GLuint link(const crease::pass& pass) {
    const GLuint program = glCreateProgram();
    attach(program, GL_VERTEX_SHADER, pass.vertex_pieces);
    attach(program, GL_FRAGMENT_SHADER, pass.pieces);
    glLinkProgram(program);
    GLint linked = 0;
    glGetProgramiv(program, GL_LINK_STATUS, &linked);
    if (!linked) {
        char log[4096]{};
        glGetProgramInfoLog(program, sizeof log, nullptr, log);
        throw std::runtime_error(log);
    }
    return program;
}

GLenum format_of(crease::format texels) {
    switch (texels) {
    case crease::format::r8_unorm:
        return GL_R8;
    case crease::format::r32_uint:
        return GL_R32UI;
    case crease::format::d32_float:
        return GL_DEPTH_COMPONENT32F;
    default:
        throw std::runtime_error("a format that this effect does not use");
    }
}

/// A texture for each resource of the effect; 0 for the block of parameters.
std::vector<GLuint> make_textures() {
    std::vector<GLuint> textures;
    for (const crease::resource& resource : ao::resources) {
        textures.push_back(0);
        if (resource.kind == crease::resource_kind::block)
            continue;
        glGenTextures(1, &textures.back());
        glBindTexture(GL_TEXTURE_2D, textures.back());
        glTexStorage2D(GL_TEXTURE_2D, 1, format_of(resource.texels),
                       static_cast<GLsizei>(resource.size.width_of(picture::width)),
                       static_cast<GLsizei>(resource.size.height_of(picture::height)));
    }
    return textures;
}

void run(const crease::pass& pass, const std::vector<GLuint>& textures, GLuint parameters) {
    for (const crease::binding& binding : pass.bindings)
        if (binding.how == crease::access::uniform) {
            glBindBufferBase(GL_UNIFORM_BUFFER, binding.slot, parameters);
        } else if (binding.how == crease::access::sample) {
            glActiveTexture(GL_TEXTURE0 + binding.slot);
            glBindTexture(GL_TEXTURE_2D, textures[binding.resource]);
        } else {
            glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D,
                                   textures[binding.resource], 0);
        }
    glViewport(0, 0, static_cast<GLsizei>(pass.size.width_of(picture::width)),
               static_cast<GLsizei>(pass.size.height_of(picture::height)));
    const GLuint program = link(pass);
    glUseProgram(program);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDeleteProgram(program);
}

std::vector<std::uint8_t> render(const std::vector<float>& depth, const crease::parameters& parameters) {
    GLuint vertex_array, framebuffer, sampler, block; // go with the context
    glGenVertexArrays(1, &vertex_array);
    glBindVertexArray(vertex_array);
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glGenBuffers(1, &block);
    glBindBuffer(GL_UNIFORM_BUFFER, block);
    const auto bytes = ao::block(parameters);
    glBufferData(GL_UNIFORM_BUFFER, bytes.size(), bytes.data(), GL_STATIC_DRAW);
    glGenSamplers(1, &sampler); // as crease::access::sample asks for
    glSamplerParameteri(sampler, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glSamplerParameteri(sampler, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glSamplerParameteri(sampler, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glSamplerParameteri(sampler, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    for (GLuint unit = 0; unit < 4; ++unit)
        glBindSampler(unit, sampler);

    const std::vector<GLuint> textures = make_textures();
    for (std::size_t i = 0; i < textures.size(); ++i)
        if (ao::resources[i].name == "depth") {
            glBindTexture(GL_TEXTURE_2D, textures[i]);
            glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, picture::width, picture::height, GL_DEPTH_COMPONENT,
                            GL_FLOAT, depth.data());
        }
    for (const crease::pass& pass : ao::passes)
        run(pass, textures, block);

    std::vector<std::uint8_t> visibility(picture::width * picture::height);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, picture::width, picture::height, GL_RED, GL_UNSIGNED_BYTE, visibility.data());
    if (const GLenum code = glGetError(); code != GL_NO_ERROR)
        throw std::runtime_error("OpenGL error " + std::to_string(code));
    return visibility;
}

}

/// @param arguments  optionally the path of a PGM picture to write
int main(int count, char** arguments) {
    try {
        make_context();
        // OpenGL's own clip space: depth from -1 to 1, y up, and row 0 of an image is its lowest.
        constexpr crease::matrix_convention clip{.depth_zero_to_one = false};
        constexpr float near = 0.1f, far = 20;
        constexpr picture::matrix projection = {1,
                                                0,
                                                0,
                                                0,
                                                0,
                                                16.f / 9,
                                                0,
                                                0,
                                                0,
                                                0,
                                                (near + far) / (near - far),
                                                -1,
                                                0,
                                                0,
                                                2 * near * far / (near - far),
                                                0};
        crease::parameters parameters = ao::defaults;
        if (const auto fit =
                crease::set_projection(parameters.view, projection, picture::width, picture::height, clip);
            !fit)
            throw std::runtime_error(std::string(fit.error));
        parameters.radius = corner::radius;

        const auto visibility = render(corner::device_depth(projection, clip), parameters);
        if (count > 1)
            picture::write_pgm(arguments[1], visibility, false);
        return corner::plausible(visibility, projection) ? 0 : 1;
    } catch (const std::exception& failure) {
        std::cerr << "opengl_host: " << failure.what() << '\n';
        return 1;
    }
}
