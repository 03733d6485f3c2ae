// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <memory>

namespace {

using namespace crease;

using listed = effect<directions<2, 4>, linked_lists<6, 5, 1, 3, 20>, hbao>;
static_assert(offers<linked_lists<>, depth_layers>);
static_assert(offers<linked_lists<>, layers_behind_front>);
static_assert(!offers<linked_lists<>, layers_of_two_views>);
static_assert(listed::passes.size() == 3);
static_assert(listed::passes[0].name == "capture_layers" && listed::passes[0].stage == stage_kind::geometry);
static_assert(listed::passes[1].name == "pack_layers");
static_assert(listed::view().features.fragment_stores_and_atomics);

const resource& named(std::string_view name) {
    return *std::ranges::find(listed::resources, name, &resource::name);
}

}

TEST_CASE("a pool has nodes for each texel, and lists and counters are empty at the beginning of a frame") {
    const resource& nodes = named("list_nodes");
    CHECK(nodes.kind == resource_kind::buffer);
    CHECK(nodes.element == "uvec2");
    CHECK(nodes.layers == 5);
    CHECK(nodes.size.guarded);
    CHECK(named("list_heads").layers == 2);
    CHECK(named("list_heads").size.guarded);
    CHECK(named("list_heads").clear == ~0u);
    for (std::string_view name :
         {"list_heads", "node_count", "fragments_beyond_pool", "fragments_beyond_layers"}) {
        CAPTURE(name);
        CHECK(named(name).cleared);
    }
    for (std::string_view name : {"fragments_beyond_pool", "fragments_beyond_layers"}) {
        CAPTURE(name);
        CHECK(named(name).life == lifetime::report);
        CHECK_FALSE(named(name).meaning.empty());
    }
    CHECK(named("packed_layers").layers == 2);
}

TEST_CASE("the geometry pass is placed among the host's bindings") {
    const auto bindings = listed::passes[0].bindings;
    REQUIRE(bindings.size() == 5);
    for (std::size_t i = 0; i < bindings.size(); ++i) {
        CHECK(bindings[i].set == 1);
        CHECK(bindings[i].slot == 3 + i);
    }
}

TEST_CASE("numbers of a recipe are those of the type, and an empty pool is refused") {
    const auto same = std::make_unique<composition>(
        recipe(std::string_view("directions:2x4/linked_lists:6x5x1x3x20/hbao")));
    CHECK(static_cast<bool>(*same));
    CHECK(joined(same->view().passes[0].pieces) == listed::source<0>());
    CHECK_FALSE(static_cast<bool>(recipe(std::string_view("directions:2x4/linked_lists:6x0/hbao"))));
}

TEST_CASE("the main pass reads what is packed alone") {
    CHECK(contains(listed::source<2>(), "crease_load_packed_layers"));
    CHECK_FALSE(contains(listed::source<2>(), "crease_list_nodes"));
}
