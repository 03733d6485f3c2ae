// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

TEST_CASE("reconstructed_normals asks for nothing but depth") {
    using effect = crease::effect<crease::directions<>, crease::single_layer, crease::hbao,
                                  crease::reconstructed_normals>;
    CHECK(effect::resources.size() == 3);
    CHECK_FALSE(contains(effect::source<0>(), "sampler2D crease_normal;"));
}
