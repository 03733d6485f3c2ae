// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

static_assert(crease::recipe("box_window:15/single_layer/unsharp_mask"));
static_assert(crease::recipe("box_window:40/single_layer/unsharp_mask/shade:0"));
static_assert(!crease::recipe("directions/single_layer/unsharp_mask"));
static_assert(crease::recipe("box_area:40/summed_area_uniform:16/unsharp_mask"));
static_assert(!crease::recipe("box_window:15/summed_area/unsharp_mask"));

TEST_CASE("unsharp_mask recommends the numbers of the listing") {
    using effect = crease::effect<crease::box_window<>, crease::single_layer, crease::unsharp_mask>;
    CHECK(effect::defaults.threshold == 0.02f);
    CHECK(effect::defaults.strength == 20.0f);
    CHECK(effect::defaults.exponent == 1.0f);
}

TEST_CASE("unsharp_mask says what means over areas are of, and only over areas") {
    using loop = crease::effect<crease::box_window<>, crease::single_layer, crease::unsharp_mask>;
    using areas = crease::effect<crease::box_area<>, crease::summed_area<>, crease::unsharp_mask>;
    CHECK(piece_of(loop::passes[0], "estimator/unsharp_mask_areas.glsl").empty());
    for (const crease::pass& each : areas::passes) {
        const bool called =
            each.name == "range_of_columns" || each.name == "make_rows" || each.name == "visibility";
        CHECK(piece_of(each, "estimator/unsharp_mask_areas.glsl").empty() != called);
    }
}
