// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

#include <algorithm>

namespace {

using namespace crease;

using blended = effect<directions<2, 4>, linked_lists<6, 5>, hbao, composite<>>;
static_assert(blended::resources.back().name == "color");
static_assert(blended::resources.back().texels == format::rgba16_float);
static_assert(blended::resources.back().life == lifetime::output);

}

TEST_CASE("a composite is of every layer, where no other receivers are named") {
    CHECK(contains(blended::source<2>(), "crease_surface_at("));
    CHECK(contains(blended::source<2>(), "crease_encode_color("));
    CHECK(contains(effect<directions<2, 4>, linked_lists<6, 5>, hbao, composite<1>, thin_layers>::source<2>(),
                   "receiver.to_eye = -receiver.to_eye;"));
}

TEST_CASE("filters hand its colours on") {
    using filtered = effect<directions<2, 4>, linked_lists<6, 5>, hbao, composite<1>, bilateral<>>;
    const auto between = std::ranges::find(filtered::resources, "between_0", &resource::name);
    REQUIRE(between != std::end(filtered::resources));
    CHECK(between->texels == format::rgba32_uint);
}
