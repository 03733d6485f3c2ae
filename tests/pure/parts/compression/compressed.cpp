// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

#include <algorithm>

namespace {

using namespace crease;

template <int Nodes>
using few = effect<directions<2, 4>, linked_lists<16>, hbao, every_layer, compressed<Nodes>>;

template <class Effect>
const resource* find(std::string_view name) {
    const auto at = std::ranges::find(Effect::resources, name, &resource::name);
    return at == std::end(Effect::resources) ? nullptr : &*at;
}

}

TEST_CASE("four nodes take 24 bytes of a texel, and nothing else is packed") {
    const resource *layers = find<few<4>>("compressed_layers"), *normals = find<few<4>>("compressed_normals");
    REQUIRE(layers);
    REQUIRE(normals);
    CHECK(layers->texels == format::rgba32_uint);
    CHECK(normals->texels == format::r32_uint);
    CHECK(16 * layers->layers + 4 * normals->layers == 24);
    for (std::string_view name : {"packed_layers", "packed_opacities", "layer_surfaces"})
        CHECK_FALSE(find<few<4>>(name));
    CHECK(find<few<5>>("compressed_layers")->layers == 2);
}

TEST_CASE("the main pass touches compressed layers alone") {
    CHECK(contains(few<4>::source<2>(), "crease_load_compressed_layers("));
    CHECK_FALSE(contains(few<4>::source<2>(), "crease_list_nodes"));
}

TEST_CASE("a compression serves first surfaces too, of which no normals are kept") {
    using opaque = effect<directions<2, 4>, linked_lists<16>, hbao, compressed<8>>;
    CHECK(opaque::passes[0].takes_surfaces);
    CHECK(contains(opaque::source<2>(), "crease_depth_at("));
    const resource* layers = find<opaque>("compressed_layers");
    REQUIRE(layers);
    CHECK(layers->layers == 2);
    CHECK_FALSE(find<opaque>("compressed_normals"));
    using of_array = effect<directions<2, 4>, layer_array<16>, hbao, compressed<>>;
    CHECK(find<of_array>("fragment_surfaces")->layers == 16);
    using transparent = effect<directions<2, 4>, layer_array<16>, hbao, every_layer, compressed<>>;
    CHECK(find<transparent>("fragment_surfaces")->layers == 32);
}
