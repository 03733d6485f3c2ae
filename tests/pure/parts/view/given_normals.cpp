// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

TEST_CASE("given_normals asks for an image of normals") {
    using effect =
        crease::effect<crease::directions<>, crease::single_layer, crease::hbao, crease::given_normals>;
    CHECK(effect::resources[2].name == "normal");
    CHECK(contains(effect::source<0>(), "uniform sampler2D crease_normal;\n"));
}
