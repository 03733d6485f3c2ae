// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

TEST_CASE("bilateral is two passes that differ in the axis alone") {
    using effect =
        crease::effect<crease::directions<>, crease::single_layer, crease::hbao, crease::bilateral<3>>;
    REQUIRE(effect::passes.size() == 3);
    CHECK(effect::passes[1].name == "bilateral_x");
    CHECK(effect::passes[2].name == "bilateral_y");
    CHECK(contains(effect::source<1>(), "const int crease_bilateral_axis = 0;\n"));
    CHECK(contains(effect::source<2>(), "const int crease_bilateral_axis = 1;\n"));
    CHECK(contains(effect::source<2>(), "const int crease_bilateral_radius = 3;\n"));
    CHECK(get(effect::defaults, effect::settings, "bilateral.sharpness") ==
          crease::bilateral_part::reads[0].fallback);
}

TEST_CASE("what bilateral reads carries depth, what it writes last does not") {
    using effect =
        crease::effect<crease::directions<>, crease::single_layer, crease::hbao, crease::bilateral<>>;
    CHECK(effect::resources[effect::passes[0].bindings.back().resource].texels == crease::format::r32_uint);
    CHECK(effect::resources[effect::passes[1].bindings.back().resource].texels == crease::format::r32_uint);
    CHECK(effect::resources[effect::passes[2].bindings.back().resource].texels == crease::format::r8_unorm);
}
