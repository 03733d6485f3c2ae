// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include <doctest/doctest.h>

namespace {

using namespace crease;

using at_once = effect<directions<4, 4>, stochastic_layers<4>, hbao, front_first<>>;
using later = effect<directions<4, 4>, stochastic_layers<4>, hbao, deferred_layers<>>;

}

TEST_CASE("both traversals that look at the front first have a reach, each its own") {
    CHECK(get(at_once::defaults, at_once::settings, "front_first.reach") == 0.3f);
    CHECK(get(later::defaults, later::settings, "deferred_layers.reach") == 0.3f);
    CHECK(get(at_once::defaults, at_once::settings, "deferred_layers.reach") == 0);
    parameters p = later::defaults;
    CHECK(later::set<"reach">(p, 1));
    CHECK_FALSE(later::set<"reach">(p, 1.5f)); // radii
    CHECK(get(p, later::settings, "reach") == 1);
}

TEST_CASE("both need layers behind the front one") {
    CHECK(has(front_first_part::description.needs, &layers_behind_front::value));
    CHECK(has(deferred_layers_part::description.needs, &layers_behind_front::value));
    CHECK_FALSE(recipe("directions/single_layer/hbao/front_first"));
    CHECK_FALSE(recipe("directions/single_layer/hbao/deferred_layers"));
}
