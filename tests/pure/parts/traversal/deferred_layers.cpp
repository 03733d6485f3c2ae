// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

namespace {

using namespace crease;

static_assert(recipe("directions/stochastic_layers/hbao/deferred_layers"));
static_assert(recipe("directions/stochastic_layers/hbao/deferred_layers/bent_cone"));
static_assert(!recipe("directions/single_layer/hbao/deferred_layers"));

using deferred = effect<directions<>, stochastic_layers<>, hbao, deferred_layers<0, 2>>;

}

TEST_CASE("deferred_layers adds what it finds behind by the estimator's own function") {
    CHECK(has_part_of(deferred::passes.back(), "traversal/deferred_layers.glsl"));
    CHECK(contains(part_of(deferred::passes.back(), "estimator/hbao.glsl"), "void crease_add_behind("));
    CHECK(contains(deferred::source<2>, "crease_deferred_layers_looks = 2;\n"));
    CHECK(get(deferred::defaults, deferred::settings, "deferred_layers.reach") == 0.3f);
    using all = effect<directions<>, stochastic_layers<>, hbao>;
    CHECK_FALSE(contains(all::source<2>, "crease_add_behind"));
}
