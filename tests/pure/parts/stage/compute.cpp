// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

TEST_CASE("compute takes the size of its workgroup, as specialization constants 0 and 1") {
    using effect =
        crease::effect<crease::directions<>, crease::single_layer, crease::hbao, crease::compute<8, 4>>;
    CHECK(effect::passes[0].group_width() == 8);
    CHECK(effect::passes[0].group_height() == 4);
    CHECK(contains(effect::source<0>(), "layout(local_size_x = 8, local_size_y = 4, local_size_x_id = 0, "
                                        "local_size_y_id = 1) in;\n"));
    CHECK(effect::passes[0].bindings.back().how == crease::access::store);
}
