// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

static_assert(crease::offers<crease::box_area<>, crease::area_taps>);
static_assert(crease::offers<crease::box_area<>, crease::window_taps>);
static_assert(!crease::recipe("box_area/single_layer/unsharp_mask"));

TEST_CASE("box_area's size is a specialization constant") {
    using effect = crease::effect<crease::box_area<15>, crease::summed_area<>, crease::unsharp_mask>;
    CHECK(contains(effect::passes.back().pieces[0].text, "const int crease_box_area_size = 15;\n"));
}
