// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

TEST_CASE("perspective is the projection where none is named") {
    using named =
        crease::effect<crease::directions<>, crease::single_layer, crease::hbao, crease::perspective>;
    using unnamed = crease::effect<crease::directions<>, crease::single_layer, crease::hbao>;
    CHECK(named::source<0> == unnamed::source<0>);
    CHECK_FALSE(piece_of(unnamed::passes[0], "view/perspective.glsl").empty());
}
