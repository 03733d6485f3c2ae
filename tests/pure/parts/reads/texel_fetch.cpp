// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include <doctest/doctest.h>

TEST_CASE("texel_fetch is the way of reading where none is named: by samplers") {
    using named = crease::effect<crease::directions<>, crease::single_layer, crease::hbao, crease::bilateral<>,
                                 crease::linearised_depth, crease::texel_fetch>;
    for (const crease::pass& each : named::passes)
        for (const crease::binding& b : each.bindings)
            CHECK(b.how != crease::access::load);
    CHECK(crease::complete(crease::recipe("directions/single_layer/hbao").choices())[10].what ==
          &crease::texel_fetch::description);
}
