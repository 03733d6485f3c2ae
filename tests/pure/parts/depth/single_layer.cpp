// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

static_assert(crease::offers<crease::single_layer, crease::depth_layers>);
static_assert(crease::single_layer::description.steps.empty());

TEST_CASE("single_layer needs nothing but the depth of the receivers") {
    using effect = crease::effect<crease::directions<>, crease::single_layer, crease::hbao>;
    CHECK(effect::resources[1].name == "depth");
    CHECK(effect::resources[1].life == crease::lifetime::input);
    CHECK(has_part_of(effect::passes[0], "depth/single_layer.glsl"));
    CHECK(effect::resources.size() == 4); // parameters, depth, normal, visibility
}
