// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

namespace {

using namespace crease;

using deferred = effect<directions<4, 8>, stochastic_layers<4>, hbao, deferred_layers<0, 2>>;
static_assert(has(deferred_layers_part::description.needs, &layers_behind::value));
static_assert(recipe("directions/stochastic_layers/hbao_plus/deferred_layers:1x4"));
static_assert(!recipe("directions/stochastic_layers/hbao/deferred_layers:1x5"));
static_assert(!recipe("directions/stochastic_layers/hbao/deferred_layers:1x0"));
static_assert(
    !recipe("hemisphere_points/stochastic_layers/ssao/deferred_layers")); // cannot add to a tap later

}

TEST_CASE("deferred_layers looks behind as many taps of four as it is told") {
    CHECK(contains(deferred::source<2>(), "const int crease_deferred_layers_looks = 2;"));
    CHECK(contains(deferred::source<2>(), "const int crease_deferred_layers_angle = 0;"));
    CHECK(contains(deferred::source<2>(), "crease_add_behind(marches[at], looks[i].front, all);"));
    CHECK(contains(deferred::source<1>(), "return depth > front + 1e-4 * front;"));
    CHECK_FALSE(contains(deferred::source<2>(), "void crease_traverse(")); // its loop is its own
}
