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

TEST_CASE("the functions of filters stand apart from those before them, and all but the last hand on") {
    using effect = crease::effect<crease::directions<>, crease::single_layer, crease::hbao,
                                  crease::bilateral<>, crease::functions<3, 7, 30>>;
    REQUIRE(effect::passes.size() == 3);
    CHECK(contains(effect::source<0>(), "uvec4 crease_handed_on(ivec2 pixel) {"));
    CHECK_FALSE(contains(effect::source<0>(), "crease_visibility("));
    CHECK(contains(effect::source<1>(), "uvec4 crease_handed_on(ivec2 pixel) {"));
    CHECK(contains(effect::source<2>(), "float crease_visibility(ivec2 pixel) {"));
    for (unsigned i = 0; i < 3; ++i) {
        CAPTURE(i);
        const crease::pass& each = effect::passes[i];
        CHECK(each.bindings[0].set == 3 + i);
        CHECK(each.bindings[0].slot == 7);
        CHECK(each.constants[0].id == 30 + 32 * i);
        CHECK(each.bindings.back().how == crease::access::result);
    }
    CHECK(effect::resources[effect::passes[0].bindings.back().resource].name == "between_0");
}
