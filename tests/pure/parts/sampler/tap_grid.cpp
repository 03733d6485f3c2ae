// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

static_assert(crease::offers<crease::tap_grid<>, crease::screen_taps>);
static_assert(!crease::offers<crease::tap_grid<>, crease::ordered_taps>);
static_assert(!crease::recipe("tap_grid:1/single_layer/hbao_plus"));

TEST_CASE("tap_grid has as many taps to a side as its number says, and takes no noise") {
    using effect = crease::effect<crease::tap_grid<9>, crease::single_layer, crease::hbao_plus>;
    CHECK(contains(effect::source<0>(), "const int crease_tap_grid_side = 9;\n"));
    CHECK(has_part_of(effect::passes[0], "sampler/tap_grid.glsl"));
    CHECK_FALSE(contains(effect::source<0>(), "crease_noise"));
}
