// SPDX-License-Identifier: MIT
// Every legal composition compiles, is valid for Vulkan, and has the interface that its effect declares.
#include "pure/compositions.hpp"

#include <crease/spirv.hpp>

#include <doctest/doctest.h>

#include <memory>
#include <set>
#include <span>

namespace {

std::string joined(std::span<const crease::piece> pieces) {
    std::string text;
    for (const crease::piece& p : pieces)
        text += p.text;
    return text;
}

/// A host's compute shader around functions.
std::string around(std::string_view functions) {
    return "#version 450\nlayout(local_size_x = 8) in;\n" + std::string(functions) +
           "\nlayout(set = 0, binding = 9) buffer host_result { float host_value; };\n"
           "void main() { host_value = crease_visibility(ivec2(gl_GlobalInvocationID.xy)); }\n";
}

void check_vulkan(const crease::effect_view& effect, const crease::pass& p) {
    const crease::spirv::words module = crease::spirv::compile(p);
    crease::spirv::validate(module);
    CHECK(crease::spirv::mismatches(effect, p, crease::spirv::reflect(module)) == std::vector<std::string>{});
    if (p.stage == crease::stage_kind::fragment)
        crease::spirv::validate(crease::spirv::compile_vertex(p));
}

/// A host's geometry pass around a capture: it compiles, is valid and has the interface that the effect
/// declares.
void check_capture(const crease::effect_view& effect, const crease::capture& c) {
    const bool vulkan = c.dialect == crease::dialect_kind::vulkan;
    std::vector<crease::piece> whole{{"version", vulkan ? "#version 450\n" : "#version 430\n"}};
    whole.insert(whole.end(), c.pieces.begin(), c.pieces.end());
    whole.push_back(
        {"host", vulkan ? "layout(location = 0) in vec3 host_position;\n"
                          "void main() { crease_capture(host_position); }\n"
                        : "in vec3 host_position;\nvoid main() { crease_capture(host_position); }\n"});
    if (!vulkan) {
        crease::spirv::detail::parse(whole, crease::spirv::shader_stage::fragment, c.dialect, "the capture");
        return;
    }
    const crease::spirv::words module =
        crease::spirv::compile(whole, crease::spirv::shader_stage::fragment, "the capture");
    crease::spirv::validate(module);
    CHECK(crease::spirv::mismatches(effect, c, crease::spirv::reflect(module)) == std::vector<std::string>{});
}

void check_functions(const crease::pass& p) {
    const std::string program = p.dialect == crease::dialect_kind::vulkan ? around(joined(p.pieces)) : "";
    if (program.empty())
        return; // the same text but for its layouts, which the programs in this dialect cover
    const crease::piece whole[] = {{"host", program}};
    crease::spirv::validate(crease::spirv::compile(whole, crease::spirv::shader_stage::compute, "host"));
}

}

TEST_CASE("legal compositions of all parts") {
    std::set<std::string> seen; // many compositions share passes to the letter
    std::size_t effects = 0;
    for (const std::string& text : every_recipe()) {
        CAPTURE(text);
        const crease::recipe chosen{std::string_view(text)};
        const auto composed = std::make_unique<crease::composition>(chosen);
        const crease::effect_view effect = composed->view();
        for (const crease::capture& c : effect.captures)
            if (seen.insert(joined(c.pieces)).second)
                CHECK_NOTHROW(check_capture(effect, c));
        for (const crease::pass& p : effect.passes) {
            if (!seen.insert(joined(p.pieces)).second)
                continue;
            if (p.stage == crease::stage_kind::functions)
                CHECK_NOTHROW(check_functions(p));
            else if (p.dialect == crease::dialect_kind::opengl)
                CHECK_NOTHROW(crease::spirv::check_opengl(p));
            else
                CHECK_NOTHROW(check_vulkan(effect, p));
        }
        ++effects;
    }
    MESSAGE(effects << " effects of " << seen.size() << " different programs");
    CHECK(effects > 1000);
}

TEST_CASE("optimised modules stay valid and keep their constants") {
    const crease::recipe chosen("directions:8x4/single_layer/hbao/bilateral/upsample:2");
    const auto composed = std::make_unique<crease::composition>(chosen);
    for (const crease::pass& p : composed->view().passes)
        for (crease::spirv::goal aim : {crease::spirv::goal::speed, crease::spirv::goal::size}) {
            const crease::spirv::words module = crease::spirv::optimise(crease::spirv::compile(p), aim);
            crease::spirv::validate(module);
            CHECK(crease::spirv::reflect(module).constants.size() == p.constants.size());
        }
}
