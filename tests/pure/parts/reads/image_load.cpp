// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

namespace {

using namespace crease;

using filtered = effect<directions<4, 4>, single_layer, hbao, bilateral<>, image_load>;
static_assert(has(image_load::description.offers, &image_loads::value));

}

TEST_CASE("image_load makes storage images of what passes hand on, and of nothing that the host fills") {
    unsigned inputs = 0;
    for (const pass& each : filtered::passes)
        for (const binding& b : each.bindings) {
            if (b.name == "input") {
                ++inputs;
                CHECK(b.how == access::load);
            }
            if (filtered::resources[b.resource].life == lifetime::input &&
                filtered::resources[b.resource].kind == resource_kind::image)
                CHECK(b.how == access::sample);
        }
    CHECK(inputs == 2);
    CHECK(contains(filtered::source<1>(), "imageLoad(crease_input, texel)"));
    CHECK(contains(filtered::source<1>(), ") uniform readonly uimage2D crease_input;"));
    CHECK_FALSE(contains(filtered::source<1>(), "texelFetch(crease_input"));
}

TEST_CASE("image_load leaves multisampled images to be fetched, as they are no storage images") {
    using layered = effect<directions<4, 4>, stochastic_layers<4>, hbao, multisampled<>, image_load>;
    CHECK(contains(layered::source<1>(), "texelFetch(crease_captured_layers, texel, sample_index)"));
    CHECK(contains(layered::source<2>(), "imageLoad(crease_packed_layers"));
}
