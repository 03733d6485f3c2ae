// SPDX-License-Identifier: MIT
#pragma once

#include <crease/effect/effect_view.hpp>
#include <crease/spirv/module.hpp>
#include <crease/spirv/vulkan_version.hpp>

#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>

#include <memory>
#include <span>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace crease::spirv {

/// The stages that can be compiled.
enum class shader_stage : unsigned char { vertex, fragment, compute };

}

namespace crease::spirv::detail {

/// Keeps glslang's process-wide state alive from first use to the end of the program.
inline void use_glslang() {
    static const struct process {
        process() {
            if (!glslang::InitializeProcess())
                throw error("glslang cannot be initialised");
        }
        ~process() { glslang::FinalizeProcess(); }
    } initialised;
}

constexpr EShLanguage language_of(shader_stage stage) {
    switch (stage) {
    case shader_stage::vertex:
        return EShLangVertex;
    case shader_stage::fragment:
        return EShLangFragment;
    default:
        return EShLangCompute;
    }
}

/// What a version of Vulkan takes: the version itself and that of SPIR-V.
struct glslang_target {
    glslang::EShTargetClientVersion vulkan;
    glslang::EShTargetLanguageVersion spirv;
};

constexpr glslang_target target_of(vulkan_version version) {
    constexpr glslang_target targets[] = {{glslang::EShTargetVulkan_1_0, glslang::EShTargetSpv_1_0},
                                          {glslang::EShTargetVulkan_1_1, glslang::EShTargetSpv_1_3},
                                          {glslang::EShTargetVulkan_1_2, glslang::EShTargetSpv_1_5},
                                          {glslang::EShTargetVulkan_1_3, glslang::EShTargetSpv_1_6}};
    return targets[static_cast<unsigned>(version)];
}

constexpr EShMessages rules_of(dialect_kind dialect) {
    return dialect == dialect_kind::vulkan ? static_cast<EShMessages>(EShMsgSpvRules | EShMsgVulkanRules)
                                           : EShMsgDefault;
}

/// glslang's log as lines of `file:line: message`, without its decoration.
inline std::string readable(std::string_view log) {
    constexpr std::string_view mark = "ERROR: ";
    const auto says_nothing = [](const std::string& line) {
        return line.empty() || line.find("No code generated") != std::string::npos ||
               line.find("compilation terminated") != std::string::npos;
    };
    std::istringstream lines{std::string(log)};
    std::string text;
    for (std::string line; std::getline(lines, line);) {
        if (says_nothing(line))
            continue;
        while (line.back() == ' ')
            line.pop_back();
        text += '\n' + (line.starts_with(mark) ? line.substr(mark.size()) : line);
    }
    return text;
}

/// Parses one stage. Vulkan GLSL is parsed for the version of Vulkan, other GLSL as its `#version` says.
/// @param what  names the shader in errors, e.g. "pass 'visibility'"
/// @throws error  with the line `file:line: message` of the first mistake
inline std::unique_ptr<glslang::TShader> parse(std::span<const piece> pieces, shader_stage stage,
                                               dialect_kind dialect, std::string_view what,
                                               vulkan_version version = vulkan_version::v1_1) {
    use_glslang();
    std::vector<std::string> names, texts;
    for (const piece& each : pieces) {
        names.emplace_back(each.name);
        // The lines of the fence before the text count, so that a message gives the line of the file.
        texts.push_back(std::string(each.first_line - 1, '\n').append(each.text));
    }
    std::vector<const char*> name_pointers, text_pointers;
    std::vector<int> lengths;
    for (std::size_t i = 0; i < texts.size(); ++i) {
        name_pointers.push_back(names[i].c_str());
        text_pointers.push_back(texts[i].c_str());
        lengths.push_back(static_cast<int>(texts[i].size()));
    }
    auto shader = std::make_unique<glslang::TShader>(language_of(stage));
    shader->setStringsWithLengthsAndNames(text_pointers.data(), lengths.data(), name_pointers.data(),
                                          static_cast<int>(texts.size()));
    if (dialect == dialect_kind::vulkan) {
        shader->setEnvInput(glslang::EShSourceGlsl, language_of(stage), glslang::EShClientVulkan, 100);
        const glslang_target target = target_of(version);
        shader->setEnvClient(glslang::EShClientVulkan, target.vulkan);
        shader->setEnvTarget(glslang::EShTargetSpv, target.spirv);
    }
    constexpr int version_if_unsaid = 100;
    if (!shader->parse(GetDefaultResources(), version_if_unsaid, false, rules_of(dialect)))
        throw error(std::string(what) + " does not compile:" + readable(shader->getInfoLog()));
    return shader;
}

/// Links the stages added to `program`.
/// @throws error  with the linker's messages
inline void link(glslang::TProgram& program, dialect_kind dialect, std::string_view what) {
    if (!program.link(rules_of(dialect)))
        throw error(std::string(what) + " does not link:" + readable(program.getInfoLog()));
}

}
