// SPDX-License-Identifier: MIT
#pragma once

#include <crease/spirv/parse.hpp>
#include <crease/translate/limits.hpp>

namespace crease::translate::detail {

inline void parse_hlsl(const translation& made, std::string_view what) {
    spirv::detail::use_glslang();
    const EShLanguage language = spirv::detail::language_of(made.stage);
    constexpr auto rules = static_cast<EShMessages>(EShMsgReadHlsl | EShMsgSpvRules | EShMsgVulkanRules);
    constexpr int shader_model = 500;
    glslang::TShader shader(language);
    const char* const text = made.text.c_str();
    shader.setStrings(&text, 1);
    shader.setEntryPoint(made.entry_point.c_str());
    shader.setSourceEntryPoint(made.entry_point.c_str());
    shader.setEnvInput(glslang::EShSourceHlsl, language, glslang::EShClientVulkan, 100);
    shader.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_1);
    shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_3);
    if (!shader.parse(GetDefaultResources(), shader_model, false, rules))
        throw error(std::string(what) + " does not compile:" + spirv::detail::readable(shader.getInfoLog()));
    glslang::TProgram program;
    program.addShader(&shader);
    if (!program.link(rules))
        throw error(std::string(what) + " does not link:" + spirv::detail::readable(program.getInfoLog()));
}

inline void parse_glsl(const translation& made, std::string_view what) {
    const piece whole[] = {{"text", made.text}};
    const auto shader = spirv::detail::parse(whole, made.stage, dialect_kind::opengl, what);
    glslang::TProgram program;
    program.addShader(shader.get());
    spirv::detail::link(program, dialect_kind::opengl, what);
}

}

namespace crease::translate {

/// Checks a translation as a compiler of its language would begin to, by glslang's front ends for HLSL, GLSL
/// and GLSL ES. None reads MSL, of which nothing is checked.
/// @param what  names the shader in the error
/// @throws spirv::error  with the line of the first mistake
inline void check(const translation& made, std::string_view what = "the translation") {
    if (made.made_for.to == language::hlsl)
        detail::parse_hlsl(made, what);
    else if (detail::is_glsl(made.made_for))
        detail::parse_glsl(made, what);
}

}
