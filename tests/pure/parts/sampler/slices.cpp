// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

static_assert(crease::offers<crease::slices<>, crease::slice_taps>);
static_assert(crease::offers<crease::slices<>, crease::ordered_taps>);
static_assert(crease::offers<crease::slices<>, crease::screen_taps>);
static_assert(crease::recipe("slices:3x3/single_layer/hbao"));

TEST_CASE("slices, steps and their power are specialization constants") {
    using effect = crease::effect<crease::slices<5, 6>, crease::single_layer, crease::gtao>;
    CHECK(contains(effect::source<0>(), "layout(constant_id = 2) const int crease_slices_count = 5;\n"));
    CHECK(contains(effect::source<0>(), "layout(constant_id = 3) const int crease_slices_steps = 6;\n"));
    CHECK(contains(effect::source<0>(), "layout(constant_id = 4) const int crease_slices_power = 2;\n"));
}
