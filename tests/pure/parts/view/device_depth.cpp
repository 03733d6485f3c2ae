// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

TEST_CASE("device_depth asks for the depth buffer") {
    using effect =
        crease::effect<crease::directions<>, crease::single_layer, crease::hbao, crease::device_depth>;
    CHECK(effect::resources[1].texels == crease::format::d32_float);
    CHECK(contains(effect::source<0>(), "uniform sampler2D crease_depth;\n"));
}
