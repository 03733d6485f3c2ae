// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

TEST_CASE("orthographic takes the place of perspective") {
    using effect =
        crease::effect<crease::directions<>, crease::single_layer, crease::hbao, crease::orthographic>;
    CHECK_FALSE(piece_of(effect::passes[0], "view/orthographic.glsl").empty());
    CHECK(piece_of(effect::passes[0], "view/perspective.glsl").empty());
}
