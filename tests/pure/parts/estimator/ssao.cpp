// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include <doctest/doctest.h>

static_assert(crease::recipe("hemisphere_points/single_layer/ssao"));
static_assert(!crease::recipe("directions/single_layer/ssao"));
static_assert(!crease::recipe("poisson_disk/single_layer/ssao"));

TEST_CASE("ssao recommends its settings") {
    using effect = crease::effect<crease::hemisphere_points<>, crease::single_layer, crease::ssao>;
    for (const crease::setting& each : crease::ssao::reads)
        CHECK(get(effect::defaults, effect::settings, each.name) == each.fallback);
}
