// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

TEST_CASE("orthographic takes the place of perspective") {
    using effect =
        crease::effect<crease::directions<>, crease::single_layer, crease::hbao, crease::orthographic>;
    CHECK(has_part_of(effect::passes[0], "view/orthographic.glsl"));
    CHECK_FALSE(has_part_of(effect::passes[0], "view/perspective.glsl"));
}
