// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

static_assert(crease::recipe("directions/single_layer/hbao/tiled_noise"));
static_assert(!crease::recipe("directions/single_layer/hbao/tiled_noise/hashed_noise"));

TEST_CASE("tiled_noise takes the place of the default") {
    using effect = crease::effect<crease::sphere_lines<8>, crease::single_layer, crease::line_volume,
                                  crease::tiled_noise<>>;
    CHECK(piece_of(effect::passes[0], "noise/hashed_noise.glsl").empty());
    CHECK(contains(effect::source<0>, "const int crease_tiled_noise_side = 4;\n"));
}

TEST_CASE("the 16 turns of a 4 x 4 tile divide the circle with no gap of twice the mean") {
    for (double step : {(std::sqrt(5.0) - 1) / 2, std::sqrt(2.0) - 1}) {
        std::vector<double> turns;
        for (int place = 0; place < 16; ++place)
            turns.push_back(std::fmod(0.5 + place * step, 1.0));
        std::sort(turns.begin(), turns.end());
        turns.push_back(turns.front() + 1);
        for (std::size_t i = 0; i < 16; ++i) {
            CHECK(turns[i + 1] - turns[i] > 0.4 / 16);
            CHECK(turns[i + 1] - turns[i] < 2.0 / 16);
        }
    }
}
