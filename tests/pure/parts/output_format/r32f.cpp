// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

namespace {

using namespace crease;

using formatted = effect<directions<>, single_layer, hbao, bilateral<>, r32f>;
static_assert(formatted::resources.back().name == "visibility");
static_assert(formatted::resources.back().texels == format::r32_float);
static_assert(!formatted::features.extended_storage_formats);
static_assert(!recipe("directions/single_layer/hbao/r32f/rgba8"));

}

TEST_CASE("r32f is the format of visibility, and of nothing that passes hand on") {
    CHECK(contains(formatted::source<2>(),
                   "layout(r32f, set = 0, binding = 2) uniform writeonly image2D crease_output;\n"));
    CHECK(contains(formatted::source<0>(), "layout(r32ui, "));
    using bent = effect<directions<>, single_layer, hbao, bent_cone, r32f>;
    CHECK(bent::resources.back().name == "bent_cone");
    CHECK(bent::resources.back().texels == format::rgba16_float);
    CHECK(bent::resources[bent::resources.size() - 2].texels == format::r32_float);
}
