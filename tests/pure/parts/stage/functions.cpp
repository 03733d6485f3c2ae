// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

TEST_CASE("functions are no program, and stand where the host puts them") {
    using effect =
        crease::effect<crease::directions<>, crease::single_layer, crease::hbao, crease::functions<3, 7, 30>>;
    CHECK_FALSE(contains(effect::source<0>(), "void main()"));
    CHECK_FALSE(contains(effect::source<0>(), "#version"));
    CHECK(contains(effect::source<0>(), "float crease_visibility(ivec2 pixel) {"));
    const crease::pass& only = effect::passes[0];
    CHECK(only.bindings[0].set == 3);
    CHECK(only.bindings[0].slot == 7);
    CHECK(only.bindings[1].slot == 8);
    CHECK(only.bindings.back().how == crease::access::result);
    CHECK(only.constants[0].id == 30);
}
