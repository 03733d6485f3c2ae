// SPDX-License-Identifier: MIT
// What languages cannot is refused in a sentence that names pass, language and version.
#include <crease/translate/limits.hpp>

#include "spirv/little_effect.hpp"
#include "spirv/sentence.hpp"

#include <crease/translate.hpp>

#include <doctest/doctest.h>

namespace {

using namespace crease;
using spirv::shader_stage;
using translate::language;

/// What a shader is refused with, which declares and does what is given, after "pass 'tried' cannot be ".
std::string refusal(language to, unsigned version, const std::string& declarations, const std::string& body,
                    shader_stage stage = shader_stage::compute) {
    const std::string text = declarations + "void main() { " + body + " }\n";
    const piece pieces[] = {{"version", "#version 450\n"}, {"text", text}};
    const spirv::words module = spirv::compile(pieces, stage);
    pass tried;
    tried.name = "tried";
    const std::string sentence = sentence_of(
        [&] { translate::check(translate::module({}, tried, module, {.to = to, .version = version})); });
    const std::string head = "pass 'tried' cannot be ";
    CHECK((sentence.empty() || sentence.starts_with(head)));
    return sentence.substr(std::min(sentence.size(), head.size()));
}

constexpr const char* group = "layout(local_size_x = 8) in;\n";
const std::string kept =
    std::string(group) + "layout(std430, binding = 0) buffer kept_buffer { uint kept[]; };\n";

std::string image(const std::string& format, const std::string& qualifier,
                  const std::string& type = "image2D") {
    return std::string(group) + "layout(binding = 0, " + format + ") uniform " + qualifier + " " + type +
           " picture;\n";
}
constexpr const char* store = "imageStore(picture, ivec2(0), vec4(1.0));";
constexpr const char* load_and_store = "imageStore(picture, ivec2(0), imageLoad(picture, ivec2(1)));";

}

TEST_CASE("versions") {
    CHECK(refusal(language::hlsl, 40, group, "") == "HLSL 4.0: the versions of HLSL are 50, 51, 60");
    CHECK(refusal(language::msl, 20, group, "") == "MSL 2.0: the versions of MSL are 21, 22, 23, 24, 30");
    CHECK(refusal(language::glsl_es, 200, group, "") ==
          "GLSL ES 2.00: the versions of GLSL ES are 300, 310, 320");
    CHECK(refusal(language::glsl, 330, group, "") ==
          "GLSL 3.30: the versions of GLSL are 430, 440, 450, 460");
    for (const language to : {language::hlsl, language::msl, language::glsl_es, language::glsl})
        for (const unsigned each : translate::versions_of(to))
            CHECK(refusal(to, each, "", "", shader_stage::fragment).empty());
}

TEST_CASE("subgroups") {
    const std::string arithmetic = "#extension GL_KHR_shader_subgroup_arithmetic : require\n" + kept,
                      basic = "#extension GL_KHR_shader_subgroup_basic : require\n" + kept;
    const char* const add = "kept[0] = subgroupAdd(kept[1]);";
    const char* const index = "kept[0] = gl_SubgroupID;";
    CHECK(refusal(language::hlsl, 51, arithmetic, add) ==
          "HLSL 5.1: it uses operations of subgroups, which HLSL has from 6.0 on");
    CHECK(refusal(language::hlsl, 60, arithmetic, add).empty());
    CHECK(refusal(language::hlsl, 60, basic, index) ==
          "HLSL 6.0: it asks for the index of its subgroup, which HLSL does not tell");
    CHECK(refusal(language::msl, 21, arithmetic, add).empty());
    CHECK(refusal(language::glsl, 460, arithmetic, add) ==
          "GLSL 4.60: it uses operations of subgroups, which GLSL has for Vulkan alone");
    CHECK(refusal(language::glsl_es, 320, arithmetic, add) ==
          "GLSL ES 3.20: it uses operations of subgroups, which GLSL has for Vulkan alone");
}

TEST_CASE("what languages do not tell") {
    const char* const groups = "kept[0] = gl_NumWorkGroups.x;";
    CHECK(refusal(language::hlsl, 60, kept, groups) ==
          "HLSL 6.0: it asks for the number of workgroups, which HLSL does not tell");
    CHECK(refusal(language::msl, 21, kept, groups).empty());
    CHECK(refusal(language::msl, 21, kept, "kept[0] = uint(kept.length());").empty());
    const std::string sampled = kept + "layout(binding = 1) uniform sampler2D picture;\n";
    const char* const levels = "kept[0] = uint(textureQueryLevels(picture));";
    CHECK(refusal(language::glsl_es, 320, sampled, levels) ==
          "GLSL ES 3.20: it asks for the number of mip levels, which GLSL ES does not tell");
    CHECK(refusal(language::glsl, 430, sampled, levels).empty());
}

TEST_CASE("separate images and samplers, which only hosts have") {
    CHECK(refusal(language::hlsl, 50,
                  kept + "layout(binding = 1) uniform texture2D picture; layout(binding = 2) uniform sampler "
                         "nearest;\n",
                  "kept[0] = uint(texelFetch(sampler2D(picture, nearest), ivec2(0), 0).x);") ==
          "HLSL 5.0: it binds picture, and what is translated binds blocks, storage images and images with "
          "their "
          "samplers");
}

TEST_CASE("atomic operations on images") {
    const std::string changed = image("r32ui", "", "uimage2DArray");
    const char* const least = "imageAtomicMin(picture, ivec3(0), 1u);";
    CHECK(refusal(language::msl, 30, changed, least) ==
          "MSL 3.0: it changes an image by atomic operations, which MSL has from 3.1 on");
    CHECK(refusal(language::hlsl, 50, changed, least).empty());
    CHECK(refusal(language::glsl_es, 310, changed, least).empty());
    CHECK(refusal(language::glsl, 430, changed, least).empty());
}

TEST_CASE("images of GLSL ES") {
    const char* const formats =
        ", and GLSL ES has rgba8_unorm, r32_uint, rgba32_uint, r32_float, rgba16_float and "
        "rgba32_float";
    for (const auto& [glsl, name] : {std::pair("r8", "r8_unorm"), std::pair("rg32f", "rg32_float")})
        CHECK(refusal(language::glsl_es, 320, image(glsl, "writeonly"), store) ==
              "GLSL ES 3.20: it has picture as a storage image of " + std::string(name) + formats);
    for (const char* glsl : {"rgba8", "r32f", "rgba16f", "rgba32f"})
        CHECK(refusal(language::glsl_es, 310, image(glsl, "writeonly"), store).empty());
    CHECK(refusal(language::glsl_es, 310, image("r32f", ""), load_and_store).empty());
    CHECK(refusal(language::glsl_es, 310, image("rgba32f", ""), load_and_store) ==
          "GLSL ES 3.10: it reads and writes picture as a storage image of rgba32_float, which GLSL ES does "
          "with "
          "r32_float and r32_uint alone");
    CHECK(refusal(language::glsl, 430, image("rgba32f", ""), load_and_store).empty());
    CHECK(refusal(language::hlsl, 50, image("rgba32f", ""), load_and_store).empty());
}

TEST_CASE("what GLSL ES 3.00 has not") {
    const auto refused = [](unsigned es, const std::string& declarations, const std::string& body) {
        return refusal(language::glsl_es, es, "layout(location = 0) out highp vec4 colour;\n" + declarations,
                       body, shader_stage::fragment);
    };
    CHECK(refusal(language::glsl_es, 300, group, "") ==
          "GLSL ES 3.00: it is a compute shader, which GLSL ES has from 3.10 on");
    CHECK(refused(300, "layout(binding = 0) buffer kept_buffer { uint kept[]; };\n",
                  "colour = vec4(kept[0]);") ==
          "GLSL ES 3.00: it has kept_buffer as a storage block, which GLSL ES has from 3.10 on");
    const char* const samples = "layout(binding = 0) uniform sampler2DMS depth;\n";
    const char* const fetch = "colour = texelFetch(depth, ivec2(0), 1);";
    CHECK(refused(300, samples, fetch) ==
          "GLSL ES 3.00: it has depth as a multisampled image, which GLSL ES has from 3.10 on");
    CHECK(refused(310, samples, fetch).empty());
    for (const char* bits :
         {"bitCount(uint(gl_FragCoord.x))", "findMSB(uint(gl_FragCoord.x))", "findLSB(uint(gl_FragCoord.x))",
          "bitfieldExtract(uint(gl_FragCoord.x), 1, 2)"}) {
        const std::string body = "colour = vec4(float(" + std::string(bits) + "));";
        CHECK(refused(300, "", body) ==
              "GLSL ES 3.00: it counts, finds or moves bits, which GLSL ES has from 3.10 on");
        CHECK(refused(310, "", body).empty());
    }
    for (const char* bytes : {"unpackUnorm4x8(uint(gl_FragCoord.x))", "vec4(packSnorm4x8(gl_FragCoord))"}) {
        const std::string body = "colour = " + std::string(bytes) + ";";
        CHECK(refused(300, "", body) ==
              "GLSL ES 3.00: it packs or unpacks four bytes, which GLSL ES has from 3.10 on");
        CHECK(refused(310, "", body).empty());
    }
    CHECK(refused(300, "", "gl_SampleMask[0] = 1; colour = vec4(1.0);") ==
          "GLSL ES 3.00: it sets the sample mask, which GLSL ES has from 3.20 on, and 3.10 by an extension");
}
