// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include <doctest/doctest.h>

namespace {

using namespace crease;

using by_default = effect<directions<4, 4>, single_layer, hbao>;
static_assert(by_default::features.extended_storage_formats);
static_assert(!effect<directions<4, 4>, single_layer, hbao, fragment>::features.extended_storage_formats);
static_assert(r8::description.offers.empty());
static_assert(!recipe("directions/single_layer/hbao/r8/rgba8"));

}

TEST_CASE("r8 is the default: visibility in one byte") {
    CHECK(by_default::resources.back().name == "visibility");
    CHECK(by_default::resources.back().texels == format::r8_unorm);
    CHECK(effect<directions<4, 4>, single_layer, hbao, r8>::resources.back().texels == format::r8_unorm);
}
