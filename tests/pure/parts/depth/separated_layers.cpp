// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

namespace {

using namespace crease;

using separated = effect<directions<2, 4>, separated_layers<>, hbao>;
static_assert(offers<separated_layers<>, depth_layers>);
static_assert(offers<separated_layers<>, layers_behind_front>);
static_assert(!offers<separated_layers<>, layers_of_two_views>);
static_assert(separated::passes.size() == 4);
static_assert(effect<directions<2, 4>, separated_layers<3>, hbao>::passes.size() == 5);

}

TEST_CASE("two layers have a geometry pass each, in which the separation is measured in radii") {
    CHECK(separated::passes[0].name == "peel_layer_0");
    CHECK(separated::passes[1].name == "peel_layer_1");
    CHECK(separated::passes[2].name == "pack_layers");
    CHECK(contains(separated::source<1>(), "crease_separated_layers_separation * crease_radius"));
    CHECK_FALSE(contains(separated::source<3>(), "crease_separated_layers_separation *"));
}

TEST_CASE("the separation is a setting, not less than 0") {
    parameters how = separated::view().defaults;
    CHECK(set(how, separated::view().settings, "separated_layers.separation", 0.5f));
    CHECK(get(how, separated::view().settings, "separation") == 0.5f);
    CHECK_FALSE(set(how, separated::view().settings, "separation", -0.1f));
}
