// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

#include <algorithm>

namespace {

using namespace crease;

using plain = effect<directions<2, 4>, linked_lists<6, 5>, hbao>;
using widened = effect<directions<2, 4>, linked_lists<6, 5>, hbao, every_layer>;

template <class Effect>
const resource* find(std::string_view name) {
    const auto at = std::ranges::find(Effect::resources, name, &resource::name);
    return at == std::end(Effect::resources) ? nullptr : &*at;
}

}

TEST_CASE("where layers are needed with their opacity, a source of lists captures surfaces") {
    CHECK(widened::passes[0].takes_surfaces);
    CHECK_FALSE(plain::passes[0].takes_surfaces);
    CHECK_FALSE(widened::passes[1].takes_surfaces);
    CHECK(contains(widened::source<0>(), "void crease_capture(vec3 anchor, vec3 normal, vec4 color) {"));
    CHECK(contains(plain::source<0>(), "void crease_capture(vec3 anchor) {"));
    CHECK(find<widened>("list_nodes")->element == "uvec4");
    CHECK(find<plain>("list_nodes")->element == "uvec2");
    CHECK(find<widened>("list_heads")->layers == 6);
    CHECK(find<plain>("list_heads")->layers == 2);
}

TEST_CASE("taps read depths and opacities, and receivers read surfaces") {
    CHECK(find<widened>("packed_layers")->layers == 2);
    CHECK(find<widened>("packed_opacities")->layers == 2);
    CHECK(find<widened>("layer_surfaces")->layers == 6);
    CHECK_FALSE(find<plain>("packed_opacities"));
    CHECK_FALSE(find<plain>("layer_surfaces"));
    // A group is whole, so that a component is there for each layer.
    CHECK(find<effect<directions<2, 4>, linked_lists<1>, hbao, every_layer>>("packed_layers")->texels ==
          format::rgba32_float);
    CHECK(find<effect<directions<2, 4>, linked_lists<1>, hbao>>("packed_layers")->texels ==
          format::r32_float);
}
