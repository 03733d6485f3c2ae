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
std::string around(std::string_view functions, bool vulkan) {
    return std::string(vulkan ? "#version 450\n" : "#version 430\n") + "layout(local_size_x = 8) in;\n" +
           std::string(functions) +
           "\nlayout(std430, binding = 9) buffer host_result { float host_value; };\n" +
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

/// The host has all that is declared, and a buffer of its own.
void check_functions(const crease::effect_view& effect, const crease::pass& p) {
    const bool vulkan = p.dialect == crease::dialect_kind::vulkan;
    const std::string program = around(joined(p.pieces), vulkan);
    const crease::piece whole[] = {{"host", program}};
    if (!vulkan) {
        crease::pass host = p;
        host.stage = crease::stage_kind::compute;
        host.pieces = whole;
        crease::spirv::check_opengl(host);
        return;
    }
    const crease::spirv::words module =
        crease::spirv::compile(whole, crease::spirv::shader_stage::compute, "host");
    crease::spirv::validate(module);
    const crease::capture declared{
        .name = "host", .pieces = {}, .bindings = p.bindings, .constants = p.constants, .size = {}};
    CHECK(crease::spirv::mismatches(effect, declared, crease::spirv::reflect(module)) ==
          std::vector<std::string>{
              "capture 'host': the SPIR-V has host_result at set 0 binding 9, where nothing is declared"});
}

/// Checks one of `shares` parts of the different programs of all legal compositions, of which many share
/// passes to the letter.
void check_share(std::size_t share, std::size_t shares) {
    std::set<std::string> seen;
    std::size_t effects = 0, checked = 0;
    const auto is_ours = [&](std::span<const crease::piece> pieces) {
        const bool ours = seen.size() % shares == share;
        const bool is_new = seen.insert(joined(pieces)).second;
        checked += is_new && ours;
        return is_new && ours;
    };
    for (const std::string& text : every_recipe()) {
        CAPTURE(text);
        const crease::recipe chosen{std::string_view(text)};
        const auto composed = std::make_unique<crease::composition>(chosen);
        const crease::effect_view effect = composed->view();
        for (const crease::capture& c : effect.captures)
            if (is_ours(c.pieces))
                CHECK_NOTHROW(check_capture(effect, c));
        for (const crease::pass& p : effect.passes) {
            if (!is_ours(p.pieces))
                continue;
            if (p.stage == crease::stage_kind::functions)
                CHECK_NOTHROW(check_functions(effect, p));
            else if (p.dialect == crease::dialect_kind::opengl)
                CHECK_NOTHROW(crease::spirv::check_opengl(p));
            else
                CHECK_NOTHROW(check_vulkan(effect, p));
        }
        ++effects;
    }
    MESSAGE(effects << " effects of " << seen.size() << " different programs, of which " << checked
                    << " are checked here");
    CHECK(effects > 1000);
    CHECK(checked >= seen.size() / shares);
}

}

TEST_CASE("legal compositions 1 of 4") {
    check_share(0, 4);
}
TEST_CASE("legal compositions 2 of 4") {
    check_share(1, 4);
}
TEST_CASE("legal compositions 3 of 4") {
    check_share(2, 4);
}
TEST_CASE("legal compositions 4 of 4") {
    check_share(3, 4);
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
