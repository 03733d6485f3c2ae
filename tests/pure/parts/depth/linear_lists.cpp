// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <memory>

namespace {

using namespace crease;

using listed = effect<directions<2, 4>, linear_lists<6, 5, 1, 3, 20>, hbao>;
static_assert(offers<linear_lists<>, depth_layers>);
static_assert(offers<linear_lists<>, layers_behind_front>);
static_assert(!offers<linear_lists<>, layers_of_two_views>);
static_assert(listed::passes.size() == 6);
static_assert(listed::passes[0].name == "count_fragments" && listed::passes[0].stage == stage_kind::geometry);
static_assert(listed::passes[1].name == "sum_columns" && listed::passes[1].covers == dispatch::columns);
static_assert(listed::passes[2].name == "sum_row" && listed::passes[2].covers == dispatch::rows);
static_assert(listed::passes[3].name == "capture_layers" && listed::passes[3].stage == stage_kind::geometry);
static_assert(listed::passes[4].name == "pack_layers");
static_assert(listed::view().features.fragment_stores_and_atomics);

const resource& named(std::string_view name) {
    return *std::ranges::find(listed::resources, name, &resource::name);
}

}

TEST_CASE("a pool has a key for each node, and places and counters are empty at the beginning of a frame") {
    const resource& nodes = named("list_nodes");
    CHECK(nodes.kind == resource_kind::buffer);
    CHECK(nodes.element == "uint");
    CHECK(nodes.layers == 5);
    CHECK(nodes.size.guarded);
    CHECK_FALSE(nodes.cleared);
    CHECK(named("nearest_fragments").clear == ~0u);
    CHECK(named("list_places").clear == 0);
    CHECK(named("list_places").layers == 2);
    CHECK(named("column_starts").size.width_of(640, 8) == 656);
    CHECK(named("column_starts").size.height_of(360, 8) == 1);
    for (std::string_view name :
         {"nearest_fragments", "list_places", "fragments_beyond_pool", "fragments_beyond_layers"}) {
        CAPTURE(name);
        CHECK(named(name).cleared);
    }
}

TEST_CASE("one workgroup sums the lengths of all columns") {
    CHECK(listed::passes[2].size.height_of(360, 8) == 1);
    CHECK(listed::passes[2].group_height() == 1);
}

TEST_CASE("both geometry passes are placed among the host's bindings, and counting has one") {
    CHECK(listed::passes[0].bindings.size() == 1);
    CHECK(listed::passes[3].bindings.size() == 6);
    for (std::size_t pass : {0u, 3u})
        for (std::size_t i = 0; i < listed::passes[pass].bindings.size(); ++i) {
            CHECK(listed::passes[pass].bindings[i].set == 1);
            CHECK(listed::passes[pass].bindings[i].slot == 3 + i);
        }
}

TEST_CASE("numbers of a recipe are those of the type, and an empty pool is refused") {
    const auto same = std::make_unique<composition>(
        recipe(std::string_view("directions:2x4/linear_lists:6x5x1x3x20/hbao")));
    CHECK(static_cast<bool>(*same));
    CHECK(joined(same->view().passes[3].pieces) == listed::source<3>());
    CHECK_FALSE(static_cast<bool>(recipe(std::string_view("directions:2x4/linear_lists:6x0/hbao"))));
}

TEST_CASE("the scan is a part, and the main pass reads what is packed alone") {
    using by_subgroups = effect<directions<2, 4>, linear_lists<>, hbao, subgroup_scan>;
    CHECK(contains(listed::source<1>(), "crease_scan_sums"));
    CHECK(contains(by_subgroups::source<2>(), "subgroupExclusiveAdd"));
    CHECK(contains(listed::source<5>(), "crease_load_packed_layers"));
    CHECK_FALSE(contains(listed::source<5>(), "crease_list_nodes"));
}

TEST_CASE("with opacity the count finds the nearest, which has a node of its own") {
    using seen = effect<directions<2, 4>, linear_lists<6, 5>, hbao, every_layer>;
    const auto of = [](std::string_view name) {
        return *std::ranges::find(seen::resources, name, &resource::name);
    };
    CHECK(of("list_nodes").element == "uvec4");
    CHECK(of("list_nodes").layers == 6);
    CHECK(of("list_places").layers == 3);
    CHECK(seen::passes[0].bindings.size() == 3); // and the block, for the depth
    CHECK(seen::passes[0].takes_surfaces);
    CHECK(seen::passes[3].takes_surfaces);
    CHECK_FALSE(listed::passes[0].takes_surfaces);
}
