// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

#include <algorithm>

namespace {

template <class Effect>
crease::format handed_on() {
    return Effect::resources[Effect::passes[0].bindings.back().resource].texels;
}

template <class... Rest>
using ao = crease::effect<crease::directions<>, crease::single_layer, crease::hbao, Rest...>;

}

TEST_CASE("the main pass hands on a normal where a filter weighs by it, and none where none does") {
    using crease::format;
    CHECK(handed_on<ao<crease::bilateral<>>>() == format::r32_uint);
    CHECK(handed_on<ao<crease::plane_filter<>>>() == format::rg32_uint);
    CHECK(handed_on<ao<crease::bilateral<>, crease::upsample<>>>() == format::rg32_uint);
    CHECK(handed_on<ao<crease::shade<>, crease::bilateral<>>>() == format::rg32_uint);
    CHECK(handed_on<ao<crease::shade<>, crease::plane_filter<>>>() == format::rgba32_uint);
    CHECK(handed_on<ao<crease::bent_cone, crease::separable_plane_filter<>>>() == format::rgba32_uint);
    CHECK(has_part_of(ao<crease::bilateral<>>::passes[0], "core/no_normal.glsl"));
    CHECK_FALSE(has_part_of(ao<crease::bilateral<>>::passes[0], "encoding/normal.glsl"));
    CHECK(has_part_of(ao<crease::plane_filter<>>::passes[0], "encoding/normal.glsl"));
    CHECK_FALSE(has_part_of(ao<crease::plane_filter<>>::passes[0], "core/no_normal.glsl"));
}

TEST_CASE("filters that weigh by planes share how far they reach") {
    using effect = ao<crease::plane_filter<>, crease::upsample<>>;
    CHECK(std::ranges::count(effect::settings, std::string_view("plane_reach"),
                             &crease::effect_setting::name) == 1);
}
