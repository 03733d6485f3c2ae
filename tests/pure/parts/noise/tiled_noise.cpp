// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

static_assert(crease::recipe("directions/single_layer/hbao/tiled_noise"));
static_assert(!crease::recipe("directions/single_layer/hbao/tiled_noise/hashed_noise"));

TEST_CASE("tiled_noise takes the place of the default") {
    using effect = crease::effect<crease::sphere_lines<8>, crease::single_layer, crease::line_volume,
                                  crease::tiled_noise<>>;
    CHECK_FALSE(has_part_of(effect::passes[0], "noise/hashed_noise.glsl"));
    CHECK(contains(effect::source<0>(), "const int crease_tiled_noise_side = 4;\n"));
}
