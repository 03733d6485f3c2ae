// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

static_assert(crease::offers<crease::half_directions<>, crease::slice_taps>);
static_assert(crease::offers<crease::half_directions<>, crease::known_directions>);
static_assert(!crease::offers<crease::half_directions<>, crease::ordered_taps>); // its azimuths are not even
static_assert(!crease::recipe("half_directions/single_layer/hbao"));
static_assert(crease::recipe("half_directions:1x8/single_layer/cosine_bitmask/bent_cone"));

TEST_CASE("half directions by importance count the same") {
    using namespace crease;
    using drawn = effect<half_directions<2, 9, 1>, single_layer, gtao>;
    using even = effect<directions<2, 9>, single_layer, gtao>;
    CHECK(contains(drawn::source<0>(), "const int crease_half_directions_count = 2;\n"));
    CHECK(contains(drawn::source<0>(), "const int crease_half_directions_steps = 9;\n"));
    CHECK(contains(drawn::source<0>(), "const int crease_half_directions_power = 1;\n"));
    CHECK(contains(drawn::source<0>(), "float crease_slice_weight(float share) { return 1.0; }"));
    CHECK(contains(even::source<0>(), "float crease_slice_weight(float share) { return share; }"));
}
