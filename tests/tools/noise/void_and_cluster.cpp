// SPDX-License-Identifier: MIT
#include "noise/void_and_cluster.hpp"

#include <crease/parts/noise/blue_noise.hpp>

#include <doctest/doctest.h>

#include <algorithm>

using crease::tools::void_and_cluster;

TEST_CASE("void-and-cluster ranks every texel once") {
    for (unsigned side : {2u, 5u, 16u}) {
        std::vector<std::uint16_t> ranks = void_and_cluster(side);
        std::sort(ranks.begin(), ranks.end());
        for (unsigned i = 0; i < side * side; ++i)
            CHECK(ranks.at(i) == i);
    }
}

TEST_CASE("the tile of the library is what void-and-cluster makes") {
    const std::vector<std::uint16_t> ranks = void_and_cluster(crease::blue_noise_side);
    for (unsigned y = 0; y < crease::blue_noise_side; ++y)
        for (unsigned x = 0; x < crease::blue_noise_side; ++x)
            REQUIRE(crease::blue_noise::rank(x, y) == ranks[y * crease::blue_noise_side + x]);
}
