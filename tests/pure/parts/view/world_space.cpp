// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include <doctest/doctest.h>

#include <cmath>

namespace {

using namespace crease;
using of_world = effect<directions<>, single_layer, hbao, world_normals>;

/// A quarter turn about y after a quarter turn about x, and a shift, column by column.
constexpr float turned[16] = {0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 5, 6, 7, 1};

}

TEST_CASE("the rotation from world to view space is set element by element") {
    parameters p = of_world::defaults;
    REQUIRE(set_world_to_view(p, of_world::settings, turned));
    CHECK(get(p, of_world::settings, "world_xx") == 0);
    CHECK(get(p, of_world::settings, "world_xy") == 1);
    CHECK(get(p, of_world::settings, "world_yz") == 1);
    CHECK(get(p, of_world::settings, "world_zx") == 1);
    parameters by_rows = of_world::defaults, left = of_world::defaults;
    REQUIRE(set_world_to_view(by_rows, of_world::settings, turned, {.row_major = true}));
    CHECK(get(by_rows, of_world::settings, "world_yx") == 1);
    CHECK(get(by_rows, of_world::settings, "world_xz") == 1);
    REQUIRE(set_world_to_view(left, of_world::settings, turned, {.left_handed = true}));
    CHECK(get(left, of_world::settings, "world_zx") == -1);
    CHECK(get(left, of_world::settings, "world_xy") == 1);
}

TEST_CASE("a matrix with a scale, and an effect without normals of the world, are refused") {
    parameters p = of_world::defaults;
    const parameters before = p;
    float scaled[16], broken[16];
    for (int i = 0; i < 16; ++i) {
        scaled[i] = 2 * turned[i];
        broken[i] = turned[i];
    }
    broken[10] = std::nanf("");
    CHECK_FALSE(set_world_to_view(p, of_world::settings, scaled));
    CHECK_FALSE(set_world_to_view(p, of_world::settings, broken));
    CHECK(p == before);
    using of_view = effect<directions<>, single_layer, hbao>;
    parameters other = of_view::defaults;
    CHECK_FALSE(set_world_to_view(other, of_view::settings, turned));
}
