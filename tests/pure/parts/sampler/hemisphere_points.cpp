// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

static_assert(crease::offers<crease::hemisphere_points<>, crease::point_taps>);
static_assert(!crease::offers<crease::hemisphere_points<>, crease::screen_taps>);

TEST_CASE("hemisphere_points brings the tap with a point") {
    using effect = crease::effect<crease::hemisphere_points<12>, crease::single_layer, crease::ssao>;
    CHECK(contains(effect::source<0>(), "const int crease_hemisphere_points_count = 12;\n"));
    CHECK(has_part_of(effect::passes[0], "sampler/point_tap.glsl"));
    CHECK_FALSE(has_part_of(effect::passes[0], "sampler/screen_tap.glsl"));
}
