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
    CHECK(get(effect::defaults, effect::settings, "threshold") == 0.02f);
    CHECK(get(effect::defaults, effect::settings, "strength") == 20.0f);
    CHECK(get(effect::defaults, effect::settings, "exponent") == 1.0f);
}

TEST_CASE("unsharp_mask says what means over areas are of, and only over areas") {
    using loop = crease::effect<crease::box_window<>, crease::single_layer, crease::unsharp_mask>;
    using areas = crease::effect<crease::box_area<>, crease::summed_area<>, crease::unsharp_mask>;
    CHECK_FALSE(contains(loop::source<0>(), "crease_area_"));
    for (const crease::pass& each : areas::passes) {
        CAPTURE(std::string(each.name));
        const bool called =
            each.name == "range_of_columns" || each.name == "make_rows" || each.name == "visibility";
        CHECK(contains(part_of(each, "estimator/unsharp_mask.glsl"), "crease_area_") == called);
    }
}
