// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

TEST_CASE("packed_normals asks for an image of them") {
    using effect =
        crease::effect<crease::directions<>, crease::single_layer, crease::hbao, crease::packed_normals>;
    CHECK(effect::resources[2].name == "normal");
    CHECK(effect::resources[2].content == "packed_view_normals");
    CHECK(has_part_of(effect::passes[0], "view/packed_normals.glsl"));
    CHECK(has_part_of(effect::passes[0], "view/view_space.glsl"));
}
