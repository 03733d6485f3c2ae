// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

TEST_CASE("image_load reads what passes write as storage images, and inputs still by samplers") {
    using effect = crease::effect<crease::directions<>, crease::single_layer, crease::hbao, crease::bilateral<>,
                                  crease::linearised_depth, crease::image_load>;
    for (const crease::pass& each : effect::passes)
        for (const crease::binding& b : each.bindings) {
            if (b.name == "linearised_depth" && each.name != "linearise")
                CHECK(b.how == crease::access::load);
            if (b.name == "input")
                CHECK(b.how == crease::access::load);
            if (b.name == "depth" || b.name == "normal")
                CHECK(b.how == crease::access::sample);
        }
    CHECK(contains(effect::source<2>, "return imageLoad(crease_input, texel); }\n"));
}
