// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

namespace {

using namespace crease;

using skips = effect<directions<4, 4>, stochastic_layers<4>, hbao, front_first<>>;
using never_skips = effect<hemisphere_points<8>, stochastic_layers<4>, ssao, front_first<0>>;
static_assert(!recipe("directions/stochastic_layers/hbao/front_first:2"));
static_assert(!recipe("directions/stochastic_layers/hbao_plus/front_first/second_view"));

}

TEST_CASE("front_first goes with any estimator, and keeps only what lies behind the front") {
    CHECK(contains(skips::source<1>(), "return depth > front + 1e-4 * front;"));
    CHECK(contains(skips::source<2>(), "const int crease_front_first_angle = 1;"));
    CHECK(contains(skips::source<2>(), "return !(rise > march.rise);")); // what the estimator skips
    CHECK(contains(never_skips::source<2>(), "const int crease_front_first_angle = 0;"));
}
