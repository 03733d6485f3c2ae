// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

namespace {

using namespace crease;

using filtered = effect<directions<4, 4>, single_layer, hbao, bilateral<>>;
static_assert(!has(texel_fetch::description.offers, &image_loads::value));
static_assert(!recipe("directions/single_layer/hbao/texel_fetch/image_load"));

}

TEST_CASE("texel_fetch is the default: what a pass writes the next fetches from a sampled image") {
    const pass& after = filtered::passes[1];
    bool found = false;
    for (const binding& b : after.bindings)
        if (b.name == "input") {
            found = true;
            CHECK(b.how == access::sample);
        }
    CHECK(found);
    CHECK(contains(filtered::source<1>(), "texelFetch(crease_input, texel, 0)"));
    CHECK_FALSE(contains(filtered::source<1>(), "imageLoad"));
    CHECK(effect<directions<4, 4>, single_layer, hbao, bilateral<>, texel_fetch>::passes.size() == 3);
}
