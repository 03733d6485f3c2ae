// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

static_assert(crease::offers<crease::box_window<>, crease::window_taps>);
static_assert(!crease::offers<crease::box_window<>, crease::screen_taps>);

TEST_CASE("box_window's size is a specialization constant") {
    using effect = crease::effect<crease::box_window<40>, crease::single_layer, crease::unsharp_mask>;
    CHECK(contains(effect::source<0>(), "layout(constant_id = 2) const int crease_box_window_size = 40;\n"));
}
