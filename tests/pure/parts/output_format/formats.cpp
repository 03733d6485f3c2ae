// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include <doctest/doctest.h>

using namespace crease;

TEST_CASE("the format of visibility is that of the part that offers one, and of an output without visibility "
          "none") {
    CHECK(offers<rgba8, four_bytes>);
    CHECK(offers<r32f, real_number>);
    CHECK_FALSE(offers<r8, four_bytes>);
    CHECK_FALSE(offers<r8, real_number>);
    using packed = effect<directions<>, single_layer, hbao, packed_bent_cone, r32f>;
    CHECK(packed::resources.back().name == "packed_bent_cone");
    CHECK(packed::resources.back().texels == format::rgba8_unorm);
}
