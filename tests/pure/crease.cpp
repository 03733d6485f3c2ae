// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "second_unit.hpp"

#include <doctest/doctest.h>

TEST_CASE("two translation units share one definition") {
    CHECK(parts_of_second_unit() == static_cast<const void*>(crease::all_parts));
    using effect = crease::effect<crease::directions<>, crease::single_layer, crease::hbao>;
    CHECK(source_of_second_unit().data() == effect::source<0>().data());
}
