// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

TEST_CASE("the opengl dialect is GLSL 430") {
    using effect =
        crease::effect<crease::directions<>, crease::single_layer, crease::hbao, crease::opengl_glsl>;
    CHECK(has_version(effect::source<0>(), "#version 430\n"));
    CHECK(effect::passes[0].dialect == crease::dialect_kind::opengl);
}
