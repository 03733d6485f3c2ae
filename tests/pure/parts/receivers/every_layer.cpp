// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

#include <algorithm>

namespace {

using namespace crease;

using transparent = effect<directions<2, 4>, linked_lists<6, 5>, hbao, every_layer>;
static_assert(offers<every_layer, blended_layers>);
static_assert(!offers<first_surface, blended_layers>);

template <class Effect>
bool reads(std::string_view name) {
    return std::ranges::find(Effect::resources, name, &resource::name) != std::end(Effect::resources);
}

}

TEST_CASE("every layer asks for each surface of a texel, and needs neither depth nor normals of the host") {
    CHECK(contains(transparent::source<2>(), "crease_surface_at("));
    CHECK(contains(transparent::source<2>(), "crease_fade("));
    CHECK_FALSE(reads<transparent>("depth"));
    CHECK_FALSE(reads<transparent>("normal"));
    CHECK(reads<effect<directions<2, 4>, linked_lists<6, 5>, hbao>>("depth"));
}
