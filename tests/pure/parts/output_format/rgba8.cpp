// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

namespace {

using namespace crease;

using four = effect<directions<4, 4>, single_layer, hbao, bilateral<>, rgba8>;
static_assert(!four::features.extended_storage_formats); // which every device can store
static_assert(has(rgba8::description.offers, &four_bytes::value));

}

TEST_CASE("rgba8 stores visibility in four bytes, and changes nothing between passes") {
    CHECK(four::resources.back().name == "visibility");
    CHECK(four::resources.back().texels == format::rgba8_unorm);
    CHECK(contains(four::source<2>(), "layout(rgba8, "));
    for (const resource& r : four::resources)
        if (r.name == "between_0")
            CHECK(r.texels == format::r32_uint);
}
