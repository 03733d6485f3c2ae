// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

namespace {

using namespace crease;

using real = effect<directions<4, 4>, single_layer, hbao, bent_cone, r32f>;
static_assert(!real::features.extended_storage_formats);
static_assert(has(r32f::description.offers, &real_number::value));

}

TEST_CASE("r32f stores visibility as it is, and leaves the other images of an output alone") {
    CHECK(contains(real::source<0>(), "layout(r32f, "));
    for (const resource& r : real::resources) {
        if (r.name == "visibility")
            CHECK(r.texels == format::r32_float);
        if (r.name == "bent_cone")
            CHECK(r.texels == format::rgba16_float);
    }
    CHECK(real::resources[real::resources.size() - 2].name == "visibility");
}
