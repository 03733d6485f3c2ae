// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <memory>
#include <string>

namespace {

using namespace crease;

using layered = effect<directions<4, 4>, stochastic_layers<6>, hbao>;
static_assert(offers<stochastic_layers<>, depth_layers>);
static_assert(offers<stochastic_layers<>, layers_behind_front>);
static_assert(offers<stochastic_layers<>, layers_of_two_views>);
static_assert(!offers<single_layer, layers_behind_front>);
static_assert(layered::passes.size() == 3);
static_assert(layered::passes[0].name == "capture_layers" &&
              layered::passes[0].stage == stage_kind::geometry);
static_assert(layered::passes[1].name == "pack_layers");
static_assert(get(layered::defaults, layered::settings, "opacity") == 0.2f);

std::unique_ptr<composition> composed(const std::string& text) {
    return std::make_unique<composition>(recipe(std::string_view(text)));
}

}

TEST_CASE("a second camera has a capture, a packing and layers of its own") {
    const auto both = composed("directions:4x4/stochastic_layers:4/hbao_plus/second_view:2/atomic_minimum");
    const effect_view view = both->view();
    REQUIRE(view.passes.size() == 5);
    CHECK(view.passes[0].name == "capture_layers");
    CHECK(view.passes[1].name == "captured_layers_1");
    CHECK(view.passes[1].size.divisor == 2);
    for (std::size_t i = 0; i < 4; ++i)
        CHECK(view.passes[i].view == i % 2);
    for (std::size_t i = 2; i < 4; ++i)
        CHECK(contains(joined(view.passes[i].pieces),
                       "const int crease_view_index = " + std::to_string(i - 2) + ";"));
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
        const auto one =
            composed("directions:4x4/stochastic_layers:" + expected.samples + "/hbao/multisampled");
        const effect_view view = one->view();
        const auto packed = std::ranges::find(view.resources, "packed_layers", &resource::name);
        REQUIRE(packed != view.resources.end());
        CHECK(packed->texels == expected.texels);
        CHECK(packed->layers == expected.groups);
    }
}

TEST_CASE("what is packed is what the storage captured, and the main pass reads nothing else of it") {
    for (const binding& b : layered::passes[1].bindings)
        if (b.name == "captured_layers")
            CHECK(b.how == access::sample);
    CHECK(layered::passes[1].bindings.back().name == "packed_layers");
    CHECK_FALSE(contains(layered::source<2>(), "crease_captured_layers"));
    CHECK(contains(layered::source<2>(), "crease_load_packed_layers"));
}
