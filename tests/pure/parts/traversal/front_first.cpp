// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

namespace {

using namespace crease;

static_assert(recipe("directions/stochastic_layers/hbao/front_first"));
static_assert(recipe("poisson_disk/stochastic_layers/hbao_plus/front_first:0"));
static_assert(recipe("hemisphere_points/stochastic_layers/ssao/front_first"));
static_assert(!recipe("directions/single_layer/hbao/front_first"));
static_assert(!recipe("sample_box/summed_area/mean_height/front_first"));

using front = effect<directions<>, stochastic_layers<>, hbao, front_first<>>;

}

TEST_CASE("front_first takes the place of all_layers, and has a reach of its own") {
    CHECK(has_part_of(front::passes.back(), "traversal/front_first.glsl"));
    CHECK_FALSE(has_part_of(front::passes.back(), "traversal/all_layers.glsl"));
    CHECK(get(front::defaults, front::settings, "front_first.reach") == 0.3f);
    CHECK(contains(front::source<2>, "crease_front_first_angle = 1;\n"));
}

TEST_CASE("an estimator that says nothing of what may be skipped is never skipped") {
    using plain = effect<hemisphere_points<>, stochastic_layers<>, point_volume, front_first<>>;
    CHECK(has_part_of(plain::passes.back(), "core/skip_behind.glsl"));
    CHECK_FALSE(has_part_of(front::passes.back(), "core/skip_behind.glsl")); // hbao says it
}
