// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

static_assert(crease::recipe("directions/single_layer/hbao/hilbert_r2_noise"));

TEST_CASE("hilbert_r2_noise takes the place of the default") {
    using effect =
        crease::effect<crease::directions<>, crease::single_layer, crease::hbao, crease::hilbert_r2_noise>;
    CHECK(has_part_of(effect::passes[0], "noise/hilbert_r2_noise.glsl"));
    CHECK_FALSE(has_part_of(effect::passes[0], "noise/hashed_noise.glsl"));
}
