// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

static_assert(crease::extent{4}.width_of(641) == 161);
static_assert(crease::extent{2}.width_of(1) == 1);

TEST_CASE("upsample makes the passes before it smaller by its factor") {
    using effect =
        crease::effect<crease::directions<>, crease::single_layer, crease::hbao, crease::upsample<4>>;
    REQUIRE(effect::passes.size() == 2);
    CHECK(effect::passes[0].size.divisor == 4);
    CHECK(effect::passes[1].size.divisor == 1);
    CHECK(contains(effect::source<0>(), "const int crease_divisor = 4;\n"));
    CHECK(contains(effect::source<1>(), "const int crease_input_divisor = 4;\n"));
    CHECK(contains(effect::source<1>(), "const int crease_upsample_factor = 4;\n"));
}

TEST_CASE("upsample reads the depth of the picture beside its input, and no normals") {
    using effect =
        crease::effect<crease::directions<>, crease::single_layer, crease::hbao, crease::upsample<>>;
    const auto& bindings = effect::passes[1].bindings;
    REQUIRE(bindings.size() == 4);
    CHECK(bindings[1].name == "depth");
    CHECK(bindings[2].name == "input");
}
