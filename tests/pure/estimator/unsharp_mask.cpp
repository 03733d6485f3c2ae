// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include <doctest/doctest.h>

static_assert(crease::recipe("box_window:15/single_layer/unsharp_mask"));
static_assert(crease::recipe("box_window:40/single_layer/unsharp_mask/shade:0"));
static_assert(!crease::recipe("directions/single_layer/unsharp_mask"));

TEST_CASE("unsharp_mask recommends the numbers of the listing") {
    using effect = crease::effect<crease::box_window<>, crease::single_layer, crease::unsharp_mask>;
    CHECK(effect::defaults.threshold == 0.02f);
    CHECK(effect::defaults.strength == 20.0f);
    CHECK(effect::defaults.exponent == 1.0f);
}
