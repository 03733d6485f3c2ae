// SPDX-License-Identifier: MIT
#include <crease/effect/extent.hpp>

#include <doctest/doctest.h>

using namespace crease;

TEST_CASE("a size follows the picture, divided and rounded up on each axis") {
    constexpr extent whole{}, half{.divisor = 2}, sixth{.divisor = 6};
    CHECK(whole.width_of(641) == 641);
    CHECK(whole.height_of(359) == 359);
    CHECK(half.width_of(641) == 321);
    CHECK(half.height_of(359) == 180);
    CHECK(half.width_of(640) == 320);
    CHECK(sixth.width_of(641) == 107);
    CHECK(sixth.height_of(359) == 60);
    CHECK(sixth.width_of(1) == 1);
    CHECK(sixth.height_of(6) == 1);
    CHECK(sixth.height_of(7) == 2);
}

TEST_CASE("a guard band lies on both sides, in the texels of the image, and only where it is asked for") {
    constexpr extent guarded{.guarded = true}, smaller{.divisor = 4, .guarded = true}, bare{.divisor = 4};
    CHECK(guarded.width_of(641, 16) == 673);
    CHECK(guarded.height_of(359, 16) == 391);
    CHECK(guarded.width_of(641) == 641);
    CHECK(smaller.width_of(641, 16) == 193);
    CHECK(smaller.height_of(359, 16) == 122);
    CHECK(bare.width_of(641, 16) == 161);
    CHECK(bare.height_of(359, 16) == 90);
}

TEST_CASE("a fixed side stays, whatever the picture and the band; the other follows") {
    constexpr extent row{.fixed_height = 1}, column{.fixed_width = 3},
        table{.fixed_width = 256, .fixed_height = 257};
    CHECK(row.width_of(641, 16) == 641);
    CHECK(row.height_of(359, 16) == 1);
    CHECK(column.width_of(641, 16) == 3);
    CHECK(column.height_of(359, 16) == 359);
    CHECK(table.width_of(641, 16) == 256);
    CHECK(table.height_of(359, 16) == 257);
}

TEST_CASE("a level halves the size with its band, rounded down, down to one texel") {
    constexpr extent third{.divisor = 2, .guarded = true, .level = 3}, deep{.level = 40},
        of_fixed{.fixed_width = 9, .fixed_height = 1, .level = 2};
    CHECK(third.width_of(641, 16) == 44); // 321 + 32, then 176, 88, 44
    CHECK(third.height_of(359, 16) == 26);
    CHECK(deep.width_of(641) == 1);
    CHECK(of_fixed.width_of(641) == 2);
    CHECK(of_fixed.height_of(359) == 1);
    CHECK(extent{.level = 1}.width_of(0) == 0);
}
