// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

TEST_CASE("separable_plane_filter is two passes that differ in the axis alone, by default over 7 texels") {
    using effect = crease::effect<crease::directions<>, crease::single_layer, crease::hbao,
                                  crease::separable_plane_filter<>>;
    REQUIRE(effect::passes.size() == 3);
    CHECK(effect::passes[1].name == "plane_filter_x");
    CHECK(effect::passes[2].name == "plane_filter_y");
    CHECK(contains(effect::source<1>(), "const int crease_separable_plane_filter_axis = 0;\n"));
    CHECK(contains(effect::source<2>(), "const int crease_separable_plane_filter_axis = 1;\n"));
    CHECK(contains(effect::source<2>(), "const int crease_separable_plane_filter_radius = 3;\n"));
}
