// SPDX-License-Identifier: MIT
// The C++ of the page of recipes does what the page says.
#include <crease/crease.hpp>

#include <doctest/doctest.h>

#include "recipes.inc"

TEST_CASE("the page's preset is its parts with its bias and another output") {
    using ao = recipes_page::ao;
    CHECK(ao::view().recipe == "directions:4x4x2/single_layer/hbao/bilateral:3/bent_cone");
    CHECK(crease::get(ao::defaults, ao::settings, "bias") == 0.3f);
}
