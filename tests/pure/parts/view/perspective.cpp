// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

TEST_CASE("perspective is the projection where none is named") {
    using named =
        crease::effect<crease::directions<>, crease::single_layer, crease::hbao, crease::perspective>;
    using unnamed = crease::effect<crease::directions<>, crease::single_layer, crease::hbao>;
    CHECK(without_recipe(named::source<0>()) == without_recipe(unnamed::source<0>()));
    CHECK(has_part_of(unnamed::passes[0], "view/perspective.glsl"));
}
