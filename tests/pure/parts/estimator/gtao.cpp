// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include <doctest/doctest.h>

static_assert(crease::recipe("slices:3x3/single_layer/gtao/bent_cone"));
static_assert(crease::recipe("half_directions:1x8/stochastic_layers:4/gtao/deferred_layers"));
static_assert(!crease::recipe("poisson_disk/single_layer/gtao"));

TEST_CASE("gtao recommends its settings") {
    using effect = crease::effect<crease::slices<>, crease::single_layer, crease::gtao>;
    for (const crease::setting& each : crease::gtao::reads)
        CHECK(get(effect::defaults, effect::settings, each.name) == each.fallback);
}
