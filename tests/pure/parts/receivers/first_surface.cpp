// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

TEST_CASE("first_surface is the receiver where none is named") {
    using effect = crease::effect<crease::directions<>, crease::single_layer, crease::hbao>;
    CHECK(has_part_of(effect::passes[0], "receivers/first_surface.glsl"));
    CHECK(crease::recipe("directions/single_layer/hbao/first_surface"));
}
