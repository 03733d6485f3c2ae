// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

namespace {

using effect = crease::effect<crease::box_window<>, crease::single_layer, crease::unsharp_mask,
                              crease::bilateral<>, crease::shade<0>>;
static_assert(effect::resources.back().name == "shade");
static_assert(effect::resources.back().texels == crease::format::r32_float);
static_assert(effect::resources[effect::resources.size() - 2].name == "visibility");

}

TEST_CASE("shade leaves with visibility, and is kept whole between passes") {
    CHECK(contains(effect::source<0>(), "const int crease_shade_highlight = 0;\n"));
    CHECK(has_part_of(effect::passes[0], "encoding/shade_depth.glsl"));
    CHECK(contains(effect::source<2>(), "imageStore(crease_shade, pixel, crease_encode_shade(result));"));
}
