// SPDX-License-Identifier: MIT
#pragma once

#include <crease/spirv/parse.hpp>

#include <glslang/SPIRV/GlslangToSpv.h>

#include <span>

namespace crease::spirv {

/// Compiles one stage of Vulkan GLSL to SPIR-V, not optimised and with the names of its GLSL.
/// @param pieces  joined in order they are the program; the first begins with `#version`
/// @param what    names the shader in errors
/// @throws error  with `file:line: message` of the first mistake, the line being that of the piece's file
inline words compile(std::span<const piece> pieces, shader_stage stage, std::string_view what = "the shader",
                     vulkan_version version = vulkan_version::v1_1) {
    const auto shader = detail::parse(pieces, stage, dialect_kind::vulkan, what, version);
    glslang::TProgram program;
    program.addShader(shader.get());
    detail::link(program, dialect_kind::vulkan, what);

    glslang::SpvOptions options;
    options.disableOptimizer = true;
    spv::SpvBuildLogger log;
    words module;
    glslang::GlslangToSpv(*program.getIntermediate(detail::language_of(stage)), module, &log, &options);
    if (module.empty())
        throw error(std::string(what) + " gives no SPIR-V:" + detail::readable(log.getAllMessages()));
    return module;
}

}

namespace crease::spirv::detail {

inline std::string title_of(const pass& which) {
    return "pass '" + std::string(which.name) + "'";
}

/// @throws error  where the pass is not a whole program for Vulkan, or for OpenGL and OpenGL ES
inline void expect_program(const pass& which, bool for_vulkan) {
    if (which.stage == stage_kind::geometry)
        throw error(title_of(which) + " is functions for the host's geometry: it has no main to compile");
    if (which.stage == stage_kind::functions)
        throw error(title_of(which) + " is functions for an engine's own shader: it has no main to compile");
    const bool is_vulkan = which.dialect == dialect_kind::vulkan;
    if (for_vulkan && !is_vulkan)
        throw error(title_of(which) + " is GLSL for " +
                    (which.dialect == dialect_kind::opengl    ? "OpenGL"
                     : which.dialect == dialect_kind::glsl_es ? "OpenGL ES"
                                                              : "WebGPU") +
                    ", which SPIR-V for Vulkan cannot be made from");
    if (!for_vulkan && (is_vulkan || which.dialect == dialect_kind::webgpu))
        throw error(title_of(which) + " is GLSL for Vulkan, not for OpenGL");
}

constexpr shader_stage stage_of(const pass& which) {
    return which.stage == stage_kind::compute ? shader_stage::compute : shader_stage::fragment;
}

}

namespace crease::spirv {

/// Compiles the compute or fragment shader of a Vulkan pass; see compile() above. One that was compiled
/// beforehand is given as it is, whatever the version.
/// @throws error  also where the pass has no main (stage `functions`) or is not for Vulkan
inline words compile(const pass& which, vulkan_version version = vulkan_version::v1_1) {
    detail::expect_program(which, true);
    if (!which.spirv.empty())
        return {which.spirv.begin(), which.spirv.end()};
    return compile(which.pieces, detail::stage_of(which), detail::title_of(which), version);
}

/// Compiles the vertex shader of a fragment pass; see compile() above.
/// @throws error  also where the pass has no vertex shader
inline words compile_vertex(const pass& which, vulkan_version version = vulkan_version::v1_1) {
    detail::expect_program(which, true);
    if (!which.vertex_spirv.empty())
        return {which.vertex_spirv.begin(), which.vertex_spirv.end()};
    if (which.vertex_pieces.empty())
        throw error(detail::title_of(which) + " has no vertex shader");
    return compile(which.vertex_pieces, shader_stage::vertex, detail::title_of(which), version);
}

/// Checks a pass for OpenGL or OpenGL ES as a driver would begin to: each stage parses as the GLSL of its
/// `#version`, and the stages of the pass link, with the outputs of the vertex shader matching the inputs of
/// the fragment shader. Makes no code, and knows no driver's limits or extensions beyond the language's.
/// @throws error  with `file:line: message` of the first mistake
inline void check_opengl(const pass& which) {
    detail::expect_program(which, false);
    const std::string what = detail::title_of(which);
    const auto main = detail::parse(which.pieces, detail::stage_of(which), which.dialect, what);
    std::unique_ptr<glslang::TShader> vertex;
    if (!which.vertex_pieces.empty())
        vertex = detail::parse(which.vertex_pieces, shader_stage::vertex, which.dialect, what);
    glslang::TProgram program;
    program.addShader(main.get());
    if (vertex)
        program.addShader(vertex.get());
    detail::link(program, which.dialect, what);
}

}
