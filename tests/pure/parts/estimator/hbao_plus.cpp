// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include <doctest/doctest.h>

static_assert(crease::recipe("directions/single_layer/hbao_plus"));
static_assert(crease::recipe("poisson_disk/single_layer/hbao_plus"));
static_assert(!crease::recipe("hemisphere_points/single_layer/hbao_plus"));

TEST_CASE("hbao_plus recommends its settings") {
    using effect = crease::effect<crease::poisson_disk<>, crease::single_layer, crease::hbao_plus>;
    for (const crease::setting& each : crease::hbao_plus::reads)
        CHECK(get(effect::defaults, effect::settings, each.name) == each.fallback);
}
