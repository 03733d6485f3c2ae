// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

TEST_CASE("linear_depth asks for linear depth and does not unpack it") {
    using effect =
        crease::effect<crease::directions<>, crease::single_layer, crease::hbao, crease::linear_depth>;
    CHECK(effect::resources[1].texels == crease::format::r32_float);
    CHECK_FALSE(has_part_of(effect::passes[0], "view/device_depth.glsl"));
}
