// SPDX-License-Identifier: MIT
// Programs as hosts have them, compiled and compared with what their effect declares.
#pragma once

#include "spirv/sentence.hpp"
#include "text/unused.hpp"

#include <crease/crease.hpp>
#include <crease/spirv.hpp>

#include <doctest/doctest.h>

#include <set>
#include <string>
#include <string_view>
#include <vector>

inline std::string text_of(const crease::pass& p) {
    std::string text;
    for (const crease::piece& each : p.pieces)
        text += each.text;
    return text;
}

/// The text without its first comment, which names the recipe.
inline std::string without_recipe(std::string text) {
    const std::size_t at = text.find("// ");
    return text.erase(at, text.find('\n', at) + 1 - at);
}

/// What a host writes before the functions of a pass.
inline std::string_view host_begins(const crease::pass& p) {
    switch (p.dialect) {
    case crease::dialect_kind::opengl:
        return "#version 430\n";
    case crease::dialect_kind::vulkan:
        return "#version 450\n";
    case crease::dialect_kind::webgpu:
        return "#version 450\n#extension GL_EXT_samplerless_texture_functions : require\n";
    default:
        return text_of(p).find("/glsl_es:300") != std::string::npos
                   ? "#version 300 es\nprecision highp float;\nprecision highp int;\n"
                   : "#version 310 es\nprecision highp float;\nprecision highp int;\n";
    }
}

/// The stage of the whole program: functions of GLSL ES stand in a fragment shader, as 3.00 has no other.
inline crease::spirv::shader_stage stage_of_whole(const crease::pass& p) {
    using enum crease::stage_kind;
    const bool is_es = p.dialect == crease::dialect_kind::glsl_es;
    return p.stage == compute || (p.stage == functions && !is_es) ? crease::spirv::shader_stage::compute
                                                                  : crease::spirv::shader_stage::fragment;
}

/// The pieces of a pass as a whole program: as they are, or within a shader of the host.
inline std::vector<crease::piece> whole_program(const crease::pass& p) {
    using namespace std::string_view_literals;
    const bool vulkan = p.dialect == crease::dialect_kind::vulkan;
    std::vector<crease::piece> whole(p.pieces.begin(), p.pieces.end());
    if (p.stage == crease::stage_kind::functions || p.stage == crease::stage_kind::geometry)
        whole.insert(whole.begin(), {"version", host_begins(p)});
    if (p.stage == crease::stage_kind::functions) {
        const bool is_last = text_of(p).find("float crease_visibility(") != std::string::npos;
        if (p.dialect == crease::dialect_kind::glsl_es) {
            whole.push_back(
                {"host",
                 is_last ? "out vec4 host_value;\n"
                           "void main() { host_value = vec4(crease_visibility(ivec2(gl_FragCoord.xy))); }\n"sv
                         : "out uvec4 host_value;\n"
                           "void main() { host_value = crease_handed_on(ivec2(gl_FragCoord.xy)); }\n"sv});
            return whole;
        }
        whole.insert(whole.begin() + 1, {"host", "layout(local_size_x = 8) in;\n"});
        whole.push_back(
            {"host",
             is_last ? "layout(std430, binding = 9) buffer host_result { float host_value; };\n"
                       "void main() { host_value = crease_visibility(ivec2(gl_GlobalInvocationID.xy)); }\n"
                     : "layout(std430, binding = 9) buffer host_result { uvec4 host_value; };\n"
                       "void main() { host_value = crease_handed_on(ivec2(gl_GlobalInvocationID.xy)); }\n"});
    } else if (p.stage == crease::stage_kind::geometry) {
        whole.push_back(
            {"host", vulkan ? "layout(location = 0) in vec3 host_position;\n" : "in vec3 host_position;\n"});
        whole.push_back(
            {"host", p.takes_surfaces
                         ? "void main() { crease_capture(host_position, vec3(0.0), vec4(1.0)); }\n"
                         : "void main() { crease_capture(host_position); }\n"});
    }
    return whole;
}

/// Checks that a program of Vulkan compiles, is valid and has the interface that the effect declares.
inline void check_vulkan(const crease::effect_view& effect, const crease::pass& p) {
    using namespace crease;
    const bool functions = p.stage == stage_kind::functions;
    const spirv::words module = spirv::compile(whole_program(p), stage_of_whole(p), p.name);
    spirv::validate(module);
    pass declared = p;
    std::vector<std::string> expected;
    if (functions) { // the host has all that is declared, and a buffer of its own
        declared.stage = stage_kind::geometry;
        expected.push_back("pass '" + std::string(p.name) +
                           "': the SPIR-V has host_result at set 0 binding 9, where nothing is declared");
    }
    CHECK(spirv::mismatches(effect, declared, spirv::reflect(module)) == expected);
    if (p.stage == stage_kind::fragment)
        spirv::validate(spirv::compile_vertex(p));
}

/// The same of OpenGL and OpenGL ES, as far as that can be told without a driver.
inline void check_opengl(const crease::pass& p) {
    using namespace crease;
    const std::vector<piece> whole = whole_program(p);
    if (p.stage == stage_kind::geometry) {
        spirv::detail::parse(whole, spirv::shader_stage::fragment, p.dialect, p.name);
        return;
    }
    pass host = p;
    if (p.stage == stage_kind::functions) {
        host.stage =
            stage_of_whole(p) == spirv::shader_stage::compute ? stage_kind::compute : stage_kind::fragment;
        host.pieces = whole;
    }
    spirv::check_opengl(host);
}

/// Adds what stands in a program without a use.
inline void collect_unused(const crease::pass& p, std::set<std::string>& without_use) {
    std::string whole;
    for (const crease::piece& each : whole_program(p))
        whole += each.text;
    for (const std::string& each : identifiers_without_use(whole))
        without_use.insert(each + " in " + std::string(p.name));
    for (const std::string& each : definitions_without_caller(whole_program(p)))
        without_use.insert(each + " in " + std::string(p.name));
}

/// Checks that a program compiles for its language.
inline void check_program(const crease::effect_view& effect, const crease::pass& p) {
    if (p.dialect == crease::dialect_kind::vulkan)
        check_vulkan(effect, p);
    else if (p.dialect == crease::dialect_kind::webgpu)
        crease::spirv::validate(crease::spirv::compile(whole_program(p), stage_of_whole(p), p.name));
    else
        check_opengl(p);
}
