// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

static_assert(crease::recipe("sphere_lines/single_layer/line_volume"));
static_assert(crease::recipe("hemisphere_lines/single_layer/line_volume"));
static_assert(!crease::recipe("sphere_points/single_layer/line_volume"));
static_assert(!crease::recipe("box_window/single_layer/line_volume"));

TEST_CASE("line_volume recommends its settings and brings what volumes share") {
    using effect = crease::effect<crease::hemisphere_lines<>, crease::single_layer, crease::line_volume>;
    for (const crease::setting& each : crease::line_volume::reads)
        CHECK(get(effect::defaults, effect::settings, each.name) == each.fallback);
    CHECK(has_part_of(effect::passes[0], "estimator/volume.glsl"));
}
