// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

TEST_CASE("hashed_noise is the default") {
    using effect = crease::effect<crease::directions<>, crease::single_layer, crease::hbao>;
    CHECK(has_part_of(effect::passes[0], "noise/hashed_noise.glsl"));
    CHECK(crease::recipe("directions/single_layer/hbao/hashed_noise"));
}
