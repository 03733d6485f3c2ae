// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

namespace {

using namespace crease;

using thin = effect<directions<2, 4>, linked_lists<6, 5>, hbao, thin_layers>;
static_assert(offers<thin_layers, blended_layers>);
static_assert(offers<hbao, both_sides> && offers<hbao_plus, both_sides> && offers<gtao, both_sides>);
static_assert(offers<cosine_bitmask<>, both_sides> && offers<visibility_bitmask, both_sides>);
static_assert(offers<ssao, both_sides> && offers<point_volume, both_sides> &&
              offers<line_volume, both_sides>);
static_assert(!offers<unsharp_mask, both_sides>);

}

TEST_CASE("thin layers ask for both sides of each surface") {
    CHECK(contains(thin::source<2>(), "receiver.to_eye = -receiver.to_eye;"));
    CHECK_FALSE(contains(effect<directions<2, 4>, linked_lists<6, 5>, hbao, every_layer>::source<2>(),
                         "receiver.to_eye = -receiver.to_eye;"));
}
