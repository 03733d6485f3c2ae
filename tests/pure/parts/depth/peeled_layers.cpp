// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

#include <string>

namespace {

using namespace crease;

using peeled = effect<directions<2, 4>, peeled_layers<3, 1, 3, 20>, hbao>;
static_assert(offers<peeled_layers<>, depth_layers>);
static_assert(offers<peeled_layers<>, layers_behind_front>);
static_assert(!offers<peeled_layers<>, layers_of_two_views>);
static_assert(peeled::passes.size() == 5);
static_assert(effect<directions<2, 4>, peeled_layers<1>, hbao>::passes.size() == 3);
static_assert(effect<directions<2, 4>, peeled_layers<8>, hbao>::passes.size() == 10);
static_assert(offers<peeled_layers<>, layers_with_opacity>);
using with_opacity = effect<directions<2, 4>, peeled_layers<3>, hbao, every_layer>;
static_assert(with_opacity::passes.size() == 6);
static_assert(with_opacity::passes[3].name == "capture_surfaces" && with_opacity::passes[3].takes_surfaces);
static_assert(peeled::view().features.fragment_stores_and_atomics);

}

TEST_CASE("each layer has a geometry pass, in which only its index differs") {
    for (std::size_t i = 0; i < 3; ++i) {
        CAPTURE(i);
        const pass& each = peeled::passes[i];
        CHECK(each.name == "peel_layer_" + std::to_string(i));
        CHECK(each.stage == stage_kind::geometry);
        CHECK(each.bindings.size() == 2);
        CHECK(each.bindings[1].set == 1);
        CHECK(each.bindings[1].slot == 4);
        CHECK(contains(joined(each.pieces), "const int crease_peeling_index = " + std::to_string(i) + ";"));
    }
    CHECK(peeled::passes[3].name == "pack_layers");
}
