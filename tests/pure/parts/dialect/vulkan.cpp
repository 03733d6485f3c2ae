// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include <doctest/doctest.h>

TEST_CASE("the vulkan dialect is GLSL 450") {
    using effect =
        crease::effect<crease::directions<>, crease::single_layer, crease::hbao, crease::vulkan_glsl>;
    CHECK(effect::source<0>.starts_with("#version 450\n"));
    CHECK(effect::passes[0].dialect == crease::dialect_kind::vulkan);
}
