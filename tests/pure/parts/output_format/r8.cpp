// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

namespace {

using namespace crease;

using formatted = effect<directions<>, single_layer, hbao, bilateral<>, r8>;
static_assert(formatted::resources.back().name == "visibility");
static_assert(formatted::resources.back().texels == format::r8_unorm);
static_assert(formatted::features.extended_storage_formats);
static_assert(!recipe("directions/single_layer/hbao/r8/rgba8"));

}

TEST_CASE("r8 is the format where none is named") {
    CHECK(contains(formatted::source<2>(),
                   "layout(r8, set = 0, binding = 2) uniform writeonly image2D crease_output;\n"));
    CHECK(contains(formatted::source<0>(), "layout(r32ui, "));
    using unnamed = effect<directions<>, single_layer, hbao, bilateral<>>;
    CHECK(without_recipe(formatted::source<2>()) == without_recipe(unnamed::source<2>()));
}
