// SPDX-License-Identifier: MIT
// Passes in other languages: entry points, names, the block of parameters, vertex shaders, a host's own
// shader.
#include <crease/translate/shader.hpp>

#include "spirv/little_effect.hpp"
#include "spirv/sentence.hpp"
#include "text/host_program.hpp"
#include "translate/declared.hpp"

#include <doctest/doctest.h>

#include <memory>

namespace {

using namespace crease;
using translate::language;
using translate::target;

const target targets[] = {{.to = language::hlsl, .version = 50},
                          {.to = language::msl, .version = 21},
                          {.to = language::glsl_es, .version = 310},
                          {.to = language::glsl, .version = 430}};

translate::translation checked(translate::translation made) {
    CAPTURE(made.text);
    CHECK_NOTHROW(translate::check(made));
    CHECK(declared_numbers(made).all == told_numbers(made));
    return made;
}

/// As HLSL writes where a member lies.
std::string at_offset(std::size_t bytes) {
    constexpr const char* components[] = {"", ".y", ".z", ".w"};
    return " : packoffset(c" + std::to_string(bytes / 16) + components[bytes % 16 / 4] + ");";
}

}

TEST_CASE("the text says what it was made of, and what it is told beside it") {
    const auto composed = std::make_unique<composition>(recipe("directions:8x4/single_layer/hbao/r32f"));
    const effect_view effect = composed->view();
    for (const target& to : targets) {
        const translate::translation made = checked(translate::shader(effect, effect.passes[0], to));
        CHECK(contains(made.text, "// directions:8x4x2/single_layer/hbao/r32f, pass visibility, as " +
                                      name_of(to) + "; crease " + std::string(version) +
                                      ", SPDX-License-Identifier: MIT-0\n"));
        CHECK(made.group_width == 16);
        CHECK(made.group_height == 16);
        CHECK(made.stage == spirv::shader_stage::compute);
        const bool begins_with_version = to.to == language::glsl || to.to == language::glsl_es;
        CHECK(made.text.starts_with(begins_with_version ? "#version " : "// directions"));
    }
}

TEST_CASE("entry points") {
    const auto entry = [](const target& to) {
        const translate::translation made = checked(translate::shader(little::effect, little::scale, to));
        CHECK(contains(made.text, "void " + made.entry_point + "("));
        return made.entry_point;
    };
    CHECK(entry(targets[0]) == "main");
    CHECK(entry(targets[1]) == "scale_main");
    CHECK(entry(targets[2]) == "main");
    CHECK(entry({.to = language::hlsl, .version = 51, .entry_point = "ScaleCS"}) == "ScaleCS");
    CHECK(entry({.to = language::msl, .version = 23, .entry_point = "scale"}) == "scale");
    CHECK(entry({.to = language::msl, .version = 23, .entry_point = "main"}) ==
          "main0"); // MSL allows no main
    CHECK(entry({.to = language::glsl, .version = 460, .entry_point = "scale"}) == "main");
}

TEST_CASE("fragment passes, and the vertex shader that covers their output") {
    constexpr const char* colour[] = {"SV_Target0", "[[color(0)]]", "layout(location = 0) out",
                                      "layout(location = 0) out"};
    constexpr const char* vertex[] = {"SV_VertexID", "[[vertex_id]]", "gl_VertexID", "gl_VertexID"};
    for (std::size_t i = 0; i < std::size(targets); ++i) {
        const translate::translation main =
            checked(translate::shader(little::effect, little::spread, targets[i]));
        CHECK(main.stage == spirv::shader_stage::fragment);
        CHECK(contains(main.text, colour[i]));
        CHECK(main.group_width == 0);
        const translate::translation whole =
            checked(translate::vertex_shader(little::effect, little::spread, targets[i]));
        CHECK(whole.stage == spirv::shader_stage::vertex);
        CHECK(contains(whole.text, vertex[i]));
        CHECK(whole.bindings.empty());
        CHECK(whole.entry_point == (targets[i].to == language::msl ? "spread_vertex" : "main"));
    }
    CHECK(sentence_of([] { translate::vertex_shader(little::effect, little::scale, targets[0]); }) ==
          "pass 'scale' has no vertex shader");
}

TEST_CASE("members of the block keep their names and lie where write_block writes them") {
    const std::string hlsl = translate::shader(little::effect, little::scale, targets[0]).text;
    CAPTURE(hlsl);
    CHECK(contains(hlsl,
                   "row_major float4x4 crease_given_from_first[1]" + at_offset(2 * sizeof(view_parameters))));
    CHECK(contains(hlsl, "float crease_given_radius" + at_offset(radius_offset(2))));
    CHECK(contains(hlsl, "uint crease_given_frame" + at_offset(radius_offset(2) + 4)));
    CHECK(contains(hlsl, "float crease_given_spread_bias" + at_offset(setting_offset(2, 0))));
    CHECK(contains(hlsl, "float crease_given_spread_slope" + at_offset(setting_offset(2, 1))));
    CHECK(contains(hlsl, "float crease_given_strength" + at_offset(setting_offset(2, 2))));
    for (const target& to : {targets[1], targets[2], targets[3]}) {
        const std::string text = translate::shader(little::effect, little::scale, to).text;
        CAPTURE(text);
        const std::string members[] = {"float radius;", "uint frame;", "float spread_bias;",
                                       "float spread_slope;", "float strength;"};
        std::size_t at = text.find("crease_parameters\n{");
        for (const std::string& member : members) { // in order, as offsets follow from it
            at = text.find(member, at);
            CHECK(at != text.npos);
        }
    }
}

TEST_CASE("buffers have the name of their binding") {
    const auto composed = std::make_unique<composition>(recipe("directions/single_layer/hbao"));
    static constexpr piece text[] = {{"text", R"(#version 450
layout(local_size_x = 8) in;
layout(std430, set = 0, binding = 0) readonly buffer crease_read_buffer { uint crease_read[]; };
layout(std430, set = 0, binding = 1) buffer crease_kept_buffer { uint crease_kept[]; };
void main() { crease_kept[gl_GlobalInvocationID.x] = crease_read[gl_GlobalInvocationID.x]; }
)"}};
    static constexpr resource resources[] = {
        {.name = "read", .kind = resource_kind::buffer, .element = "uint"},
        {.name = "kept", .kind = resource_kind::buffer, .element = "uint"}};
    static constexpr binding bindings[] = {{"read", 0, access::load, 0, 0}, {"kept", 1, access::store, 0, 1}};
    const pass copy{.name = "copy",
                    .pieces = text,
                    .vertex_pieces = {},
                    .bindings = bindings,
                    .constants = {},
                    .size = {}};
    const effect_view effect{
        .passes = {}, .resources = resources, .settings = {}, .features = {}, .defaults = {}};
    const auto numbers = [&](const target& to) {
        return told_numbers(
            checked(translate::module(effect, copy, spirv::compile(text, spirv::shader_stage::compute), to)));
    };
    using all = std::map<std::string, std::string>;
    CHECK(numbers(targets[0]) == all{{"crease_read", "t0"}, {"crease_kept", "u0"}});
    CHECK(numbers(targets[1]) == all{{"crease_read", "buffer 0"}, {"crease_kept", "buffer 1"}});
    CHECK(numbers(targets[3]) ==
          all{{"crease_read_buffer", "binding 0"}, {"crease_kept_buffer", "binding 1"}});
}

TEST_CASE("functions are translated within a host's shader, whose own bindings come last") {
    const auto composed =
        std::make_unique<composition>(recipe("poisson_disk:16/single_layer/hbao_plus/functions"));
    const effect_view effect = composed->view();
    const pass& p = effect.passes[0];
    const spirv::words module = spirv::compile(whole_program(p), spirv::shader_stage::compute);
    for (const target& to : targets) {
        CHECK(sentence_of([&] { translate::shader(effect, p, to); }) ==
              "pass 'visibility' cannot be " + name_of(to) +
                  " by itself: it is functions for an engine's own shader; compile them within that to "
                  "SPIR-V, and "
                  "translate the module");
        const translate::translation made = checked(translate::module(effect, p, module, to));
        CHECK(made.bindings.back().name == "host_result");
        CHECK(made.group_width == 8);
        target placed = to;
        placed.places["host_result"].number = 6;
        CHECK(checked(translate::module(effect, p, module, placed)).bindings.back().number == 6);
    }
}

TEST_CASE("geometry passes are translated within the host's fragment shader") {
    const auto composed =
        std::make_unique<composition>(recipe("directions/stochastic_layers/hbao/atomic_minimum"));
    const effect_view effect = composed->view();
    const pass& p = effect.passes[0];
    REQUIRE(p.stage == stage_kind::geometry);
    const spirv::words module = spirv::compile(whole_program(p), spirv::shader_stage::fragment);
    CHECK(sentence_of([&] { translate::shader(effect, p, targets[0]); }) ==
          "pass 'capture_layers' cannot be HLSL 5.0 by itself: it is functions for the host's geometry; "
          "compile them "
          "within that to SPIR-V, and translate the module");
    const translate::translation made = checked(translate::module(effect, p, module, targets[0]));
    CHECK(contains(made.text, "InterlockedMin("));
    CHECK(contains(checked(translate::module(effect, p, module, targets[2])).text,
                   "#extension GL_OES_shader_image_atomic : require"));
}

TEST_CASE("a pass for OpenGL is refused") {
    const auto composed = std::make_unique<composition>(recipe("directions/single_layer/hbao/opengl"));
    const effect_view effect = composed->view();
    CHECK(sentence_of([&] { translate::shader(effect, effect.passes[0], targets[0]); }) ==
          "pass 'visibility' is GLSL for OpenGL, which SPIR-V for Vulkan cannot be made from");
}
