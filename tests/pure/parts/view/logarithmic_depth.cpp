// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

TEST_CASE("logarithmic_depth asks for such an image and the far plane") {
    using effect =
        crease::effect<crease::directions<>, crease::single_layer, crease::hbao, crease::logarithmic_depth>;
    CHECK(effect::resources[1].content == "logarithmic_depth");
    crease::parameters p = effect::defaults;
    CHECK(effect::set<"logarithmic_depth.far">(p, 1e6f));
    CHECK_FALSE(has_part_of(effect::passes[0], "view/device_depth.glsl"));
}
