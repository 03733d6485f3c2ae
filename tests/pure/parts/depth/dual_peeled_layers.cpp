// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

#include <string>

namespace {

using namespace crease;

using peeled = effect<directions<2, 4>, dual_peeled_layers<5, 1, 3, 20>, hbao>;
static_assert(offers<dual_peeled_layers<>, depth_layers>);
static_assert(offers<dual_peeled_layers<>, layers_behind_front>);
static_assert(!offers<dual_peeled_layers<>, layers_of_two_views>);
static_assert(offers<dual_peeled_layers<>, layers_with_opacity>);
static_assert(offers<dual_peeled_layers<>, layers_with_normals>);
using with_opacity = effect<directions<2, 4>, dual_peeled_layers<5>, hbao, every_layer>;
static_assert(with_opacity::passes.size() == 6);
static_assert(with_opacity::passes[3].name == "capture_surfaces" && with_opacity::passes[3].takes_surfaces);
static_assert(peeled::passes.size() == 5);
static_assert(effect<directions<2, 4>, dual_peeled_layers<1>, hbao>::passes.size() == 3);
static_assert(effect<directions<2, 4>, dual_peeled_layers<16>, hbao>::passes.size() == 10);

}

TEST_CASE("each two layers have a geometry pass") {
    for (std::size_t i = 0; i < 3; ++i) {
        CAPTURE(i);
        const pass& each = peeled::passes[i];
        CHECK(each.name == "peel_layers_" + std::to_string(i));
        CHECK(each.stage == stage_kind::geometry);
        CHECK(each.bindings[1].set == 1);
        CHECK(each.bindings[1].slot == 4);
        CHECK(each.constants[0].id == 20);
        CHECK(contains(joined(each.pieces), "const int crease_peeling_index = " + std::to_string(i) + ";"));
    }
    CHECK(peeled::passes[3].name == "pack_layers");
}
