// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "../text.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>

namespace {

using namespace crease;

using layered = effect<directions<4, 4>, stochastic_layers<6>, hbao, atomic_minimum<1, 2, 3>, simple_hash>;
static_assert(layered::captures.size() == 1);
static_assert(!layered::captures[0].to_attachment());
static_assert(layered::features.fragment_stores_and_atomics && layered::features.depth_samples == 0);
static_assert(layered::passes.size() == 2 && layered::passes[0].name == "pack_layers");
static_assert(layered::defaults.opacity == 0.2f);
static_assert(contains(layered::captures[0].pieces[0].text,
                       "layout(constant_id = 3) const int crease_stochastic_layers_count = 6;"));
static_assert(contains(layered::captures[0].pieces[0].text, "set = 1, binding = 2"));

using sampled = effect<directions<4, 4>, stochastic_layers<6>, hbao>;
static_assert(!effect<directions<4, 4>, stochastic_layers<6>, hbao, atomic_minimum<1, 2, 3>,
                      opengl_glsl>::features.fragment_stores_and_atomics); // OpenGL asks for no feature
static_assert(sampled::captures[0].to_attachment());
static_assert(sampled::features.depth_samples == 8); // the next power of two
static_assert(effect<directions<4, 4>, stochastic_layers<8>, hbao>::features.depth_samples == 8);
static_assert(sampled::features.centred_depth_samples == 0);
static_assert(contains(sampled::captures[0].pieces.back().text, "gl_FragDepth"));
static_assert(effect<directions<4, 4>, single_layer, hbao>::captures.empty());

using centred = effect<directions<4, 4>, stochastic_layers<6>, hbao, centred_samples<>>;
static_assert(centred::features.depth_samples == 8 && centred::features.centred_depth_samples == 8);
static_assert(!contains(centred::captures[0].pieces.back().text, "gl_FragDepth"));

}

TEST_CASE("a capture's image has as many layers or samples as the depth source asks for") {
    for (const resource& r : layered::resources)
        if (r.name == "captured_layers") {
            CHECK(r.layers == 6);
            CHECK(r.clear == ~0u);
            CHECK(r.life == lifetime::captured);
        }
    for (const resource& r : sampled::resources)
        if (r.name == "captured_layers") {
            CHECK(r.samples == 8);
            CHECK(!r.centred);
        }
    for (const resource& r : centred::resources)
        CHECK(r.centred == (r.name == "captured_layers"));
}

TEST_CASE("a capture is the same from a recipe") {
    const composition composed(
        recipe("directions:4x4/stochastic_layers:6/hbao/atomic_minimum:1x2x3/simple_hash"));
    CHECK(joined(composed.view().captures[0].pieces) == layered::capture_source<0>);
}

TEST_CASE("a second camera has a capture, a packing and layers of its own") {
    const composition composed(
        recipe("directions:4x4/stochastic_layers:4/hbao_plus/second_view:2/atomic_minimum"));
    const effect_view view = composed.view();
    REQUIRE(view.captures.size() == 2);
    CHECK(view.captures[1].size.divisor == 2);
    REQUIRE(view.passes.size() == 3);
    for (std::size_t i = 0; i < 2; ++i)
        CHECK(contains(joined(view.passes[i].pieces),
                       "const int crease_view_index = " + std::to_string(i) + ";"));
    for (const resource& r : view.resources)
        if (r.name == "packed_layers")
            CHECK(r.layers == 2);
}

TEST_CASE("layers lie in groups of four; one or two need as many components") {
    struct expectation {
        std::string samples;
        format texels;
        unsigned groups;
    };
    for (const expectation& expected : {expectation{"1", format::r32_float, 1},
                                        {"2", format::rg32_float, 1},
                                        {"3", format::rgba32_float, 1},
                                        {"4", format::rgba32_float, 1},
                                        {"5", format::rgba32_float, 2}}) {
        CAPTURE(expected.samples);
        const composition composed(
            recipe("directions:4x4/stochastic_layers:" + expected.samples + "/hbao/multisampled"));
        const effect_view view = composed.view();
        const auto packed = std::ranges::find(view.resources, "packed_layers", &resource::name);
        REQUIRE(packed != view.resources.end());
        CHECK(packed->texels == expected.texels);
        CHECK(packed->layers == expected.groups);
    }
}
