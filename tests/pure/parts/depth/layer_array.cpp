// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

#include <algorithm>

namespace {

using namespace crease;

using arrayed = effect<directions<2, 4>, layer_array<6, 1, 3, 20>, hbao>;
static_assert(offers<layer_array<>, depth_layers>);
static_assert(offers<layer_array<>, layers_behind_front>);
static_assert(!offers<layer_array<>, layers_of_two_views>);
static_assert(arrayed::passes.size() == 3);
static_assert(arrayed::passes[0].name == "capture_layers" &&
              arrayed::passes[0].stage == stage_kind::geometry);
static_assert(arrayed::passes[1].name == "pack_layers");
static_assert(arrayed::view().features.fragment_stores_and_atomics);

using with_opacity = effect<directions<2, 4>, layer_array<6, 1, 3, 20>, hbao, every_layer>;
static_assert(offers<layer_array<>, layers_with_opacity>);
static_assert(with_opacity::passes.size() == 4);

const resource& named(std::string_view name) {
    return *std::ranges::find(arrayed::resources, name, &resource::name);
}

}

TEST_CASE("an array image has as many layers as are kept, empty at the beginning of a frame") {
    const resource& kept = named("fragment_layers");
    CHECK(kept.layers == 6);
    CHECK(kept.arrayed);
    CHECK(kept.size.guarded);
    CHECK(kept.cleared);
    CHECK(kept.clear == ~0u);
    CHECK(named("packed_layers").layers == 2);
    CHECK(named("fragments_beyond_layers").life == lifetime::report);
}

TEST_CASE("the geometry pass is placed among the host's bindings and constants") {
    const auto bindings = arrayed::passes[0].bindings;
    REQUIRE(bindings.size() == 3);
    CHECK(bindings[1].name == "fragment_layers");
    CHECK(bindings[2].name == "fragments_beyond_layers");
    for (std::size_t i = 0; i < bindings.size(); ++i) {
        CHECK(bindings[i].set == 1);
        CHECK(bindings[i].slot == 3 + i);
    }
    CHECK(arrayed::passes[0].constants[0].id == 20);
    CHECK(contains(arrayed::source<0>(), "const int crease_layer_array_layers = 6;"));
}

TEST_CASE("the main pass reads what is packed alone") {
    CHECK(contains(arrayed::source<2>(), "crease_load_packed_layers"));
    CHECK_FALSE(contains(arrayed::source<2>(), "crease_fragment_layers"));
}

TEST_CASE("where layers are needed with their opacity, a second geometry pass keeps their surfaces") {
    const pass& each = with_opacity::passes[1];
    CHECK(each.name == "capture_surfaces");
    CHECK(each.stage == stage_kind::geometry);
    CHECK(each.takes_surfaces);
    CHECK(with_opacity::passes[0].takes_surfaces);
    CHECK(each.bindings[1].set == 1);
    CHECK(each.bindings[1].slot == 4);
    CHECK(each.constants[0].id == 20);
    const auto surfaces = std::ranges::find(with_opacity::resources, "fragment_surfaces", &resource::name);
    REQUIRE(surfaces != with_opacity::resources.end());
    CHECK(surfaces->layers == 12);
    CHECK(surfaces->cleared);
    CHECK(surfaces->clear == 0);
}
