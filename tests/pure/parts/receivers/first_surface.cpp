// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

namespace {

using namespace crease;

using by_default = effect<directions<4, 4>, single_layer, hbao>;
static_assert(first_surface::description.kind == role::receivers);
static_assert(first_surface::description.numbers.empty() && first_surface::description.needs.empty());
static_assert(!recipe("directions/single_layer/hbao/first_surface/first_surface"));

}

TEST_CASE("first_surface is the default: one receiver a pixel, and background is open") {
    CHECK(contains(by_default::source<0>(), "return crease_result_of(crease_make_receiver("));
    CHECK(contains(by_default::source<0>(), "return crease_open_result();"));
    CHECK(contains(by_default::source<0>(), "if (!(depth > 0.0 && depth < crease_background))"));
    // A filter finds its own.
    using filtered = effect<directions<4, 4>, single_layer, hbao, bilateral<>>;
    CHECK_FALSE(contains(filtered::source<1>(), "crease_make_receiver("));
}
