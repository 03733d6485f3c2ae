// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include <doctest/doctest.h>

static_assert(crease::recipe("slices:3x3/single_layer/visibility_bitmask/bent_cone"));
static_assert(crease::recipe("half_directions:1x8/stochastic_layers:4/visibility_bitmask/deferred_layers"));
static_assert(!crease::recipe("poisson_disk/single_layer/visibility_bitmask"));

TEST_CASE("visibility_bitmask recommends its settings") {
    using effect = crease::effect<crease::slices<>, crease::single_layer, crease::visibility_bitmask>;
    for (const crease::setting& each : crease::visibility_bitmask::reads)
        CHECK(get(effect::defaults, effect::settings, each.name) == each.fallback);
}
