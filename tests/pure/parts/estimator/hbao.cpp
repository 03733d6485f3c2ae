// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include <doctest/doctest.h>

static_assert(!crease::check(crease::recipe("directions/single_layer/hbao").choices()));
static_assert(!crease::recipe("poisson_disk/single_layer/hbao"));
static_assert(!crease::recipe("hemisphere_points/single_layer/hbao"));

TEST_CASE("hbao recommends its settings") {
    using effect = crease::effect<crease::directions<>, crease::single_layer, crease::hbao>;
    for (const crease::setting& each : crease::hbao::reads)
        CHECK(get(effect::defaults, effect::settings, each.name) == each.fallback);
}
