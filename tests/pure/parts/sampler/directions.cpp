// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

static_assert(crease::offers<crease::directions<>, crease::ordered_taps>);
static_assert(crease::offers<crease::directions<>, crease::screen_taps>);
static_assert(!crease::offers<crease::directions<>, crease::point_taps>);

TEST_CASE("directions, steps and their power are specialization constants") {
    using effect = crease::effect<crease::directions<6, 3>, crease::single_layer, crease::hbao>;
    CHECK(contains(effect::source<0>(), "layout(constant_id = 2) const int crease_directions_count = 6;\n"));
    CHECK(contains(effect::source<0>(), "layout(constant_id = 3) const int crease_directions_steps = 3;\n"));
    CHECK(contains(effect::source<0>(), "layout(constant_id = 4) const int crease_directions_power = 2;\n"));
    const crease::pass& main = effect::passes[0];
    REQUIRE(main.constants.size() == 5);
    CHECK(main.constants[3].part == "directions");
    CHECK(main.constants[3].number == "steps");
    CHECK(main.constants[3].value == 3);
    CHECK(main.constants[4].number == "power");
    CHECK(main.constants[4].value == 2);
}
