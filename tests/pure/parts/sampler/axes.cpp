// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

static_assert(crease::offers<crease::axes<>, crease::ordered_taps>);
static_assert(crease::offers<crease::axes<>, crease::slice_taps>);
static_assert(!crease::recipe("axes:8x0/single_layer/hbao"));

TEST_CASE("axes has as many taps in a direction as its number says, and takes no noise") {
    using effect = crease::effect<crease::axes<5, 30>, crease::single_layer, crease::hbao>;
    CHECK(contains(effect::source<0>(), "const int crease_axes_steps = 5;\n"));
    CHECK(contains(effect::source<0>(), "const int crease_axes_reach = 30;\n"));
    CHECK(has_part_of(effect::passes[0], "sampler/axes.glsl"));
    CHECK_FALSE(contains(effect::source<0>(), "crease_noise"));
}
