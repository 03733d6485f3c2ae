// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include <doctest/doctest.h>

TEST_CASE("visibility_only leaves with one image of a byte a texel") {
    using effect = crease::effect<crease::directions<>, crease::single_layer, crease::hbao>;
    CHECK(effect::resources.back().name == "visibility");
    CHECK(effect::resources.back().texels == crease::format::r8_unorm);
    CHECK(effect::resources.back().life == crease::lifetime::output);
    CHECK(crease::recipe("directions/single_layer/hbao/visibility_only"));
}
