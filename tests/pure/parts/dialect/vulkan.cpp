// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

TEST_CASE("the vulkan dialect is GLSL 450") {
    using effect =
        crease::effect<crease::directions<>, crease::single_layer, crease::hbao, crease::vulkan_glsl>;
    CHECK(has_version(effect::source<0>(), "#version 450\n"));
    CHECK(effect::passes[0].dialect == crease::dialect_kind::vulkan);
}
