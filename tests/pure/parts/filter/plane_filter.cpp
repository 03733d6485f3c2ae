// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

static_assert(crease::recipe("directions/single_layer/hbao/plane_filter:3/plane_filter"));
static_assert(!crease::recipe("directions/single_layer/hbao/plane_filter:5"));

using effect =
    crease::effect<crease::directions<>, crease::single_layer, crease::hbao, crease::plane_filter<>>;

TEST_CASE("plane_filter is one pass, by default over 5 x 5 texels") {
    REQUIRE(effect::passes.size() == 2);
    CHECK(effect::passes[1].name == "plane_filter");
    CHECK(contains(effect::source<1>(), "const int crease_plane_filter_radius = 2;\n"));
    CHECK(get(effect::defaults, effect::settings, "plane_reach") == 0.05f);
}

TEST_CASE("plane_filter reads nothing but what the pass before hands on") {
    const auto& bindings = effect::passes[1].bindings;
    REQUIRE(bindings.size() == 3);
    CHECK(bindings[0].name == "parameters");
    CHECK(bindings[1].name == "input");
    CHECK(bindings[2].name == "output");
}
