// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

static_assert(crease::recipe("sphere_points/single_layer/point_volume"));
static_assert(crease::recipe("hemisphere_points/single_layer/point_volume"));
static_assert(!crease::recipe("sphere_lines/single_layer/point_volume"));
static_assert(!crease::recipe("poisson_disk/single_layer/point_volume"));

TEST_CASE("point_volume recommends its settings and brings what volumes share") {
    using effect = crease::effect<crease::sphere_points<17>, crease::single_layer, crease::point_volume>;
    for (const crease::setting& each : crease::point_volume::reads)
        CHECK(get(effect::defaults, effect::settings, each.name) == each.fallback);
    CHECK(has_part_of(effect::passes[0], "estimator/volume.glsl"));
}
