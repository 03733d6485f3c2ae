// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

#include <algorithm>

namespace {

using namespace crease;

using few = effect<directions<2, 4>, linked_lists<16>, hbao, every_layer, compressed_occluders<4, 1>>;
static_assert(offers<compressed_occluders<>, all_surfaces> && !offers<compressed<>, all_surfaces>);

template <class Effect = few>
bool has_resource(std::string_view name) {
    return std::ranges::find(Effect::resources, name, &resource::name) != std::end(Effect::resources);
}

}

TEST_CASE("taps read compressed layers, and receivers every surface") {
    CHECK(has_resource("compressed_layers"));
    CHECK(has_resource("layer_surfaces"));
    CHECK_FALSE(has_resource("compressed_normals"));
    CHECK_FALSE(has_resource("packed_layers"));
}

TEST_CASE("nothing is kept for receivers that are first surfaces") {
    using opaque = effect<directions<2, 4>, linked_lists<16>, hbao, compressed_occluders<>>;
    CHECK(has_resource<opaque>("compressed_layers"));
    CHECK_FALSE(has_resource<opaque>("layer_surfaces"));
}
