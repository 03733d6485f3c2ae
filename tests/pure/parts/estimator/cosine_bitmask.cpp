// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

#include <cmath>

static_assert(crease::recipe("half_directions:1x8/single_layer/cosine_bitmask:1x0/bent_cone"));
static_assert(crease::recipe("directions:4x8/stochastic_layers:4/cosine_bitmask/front_first"));
static_assert(!crease::recipe("half_directions/single_layer/cosine_bitmask:2"));
static_assert(!crease::recipe("poisson_disk/single_layer/cosine_bitmask"));

TEST_CASE("the truth and the rule for isolated taps are specialization constants") {
    using namespace crease;
    using drawn = effect<half_directions<>, single_layer, cosine_bitmask<1, 0>>;
    CHECK(contains(drawn::source<0>(), "const int crease_cosine_bitmask_linear = 1;\n"));
    CHECK(contains(drawn::source<0>(), "const int crease_cosine_bitmask_isolated = 0;\n"));
    CHECK(get(drawn::defaults, drawn::settings, "thickness") == 0.4f);
}

TEST_CASE("the measure of a lobe's half without asin is at most 0.028 off") {
    CHECK(contains(crease::cosine_bitmask_glsl.text, "crease_cosine_bitmask_cubic = 0.42920367"));
    for (int i = -1000; i <= 1000; ++i) {
        const double s = i / 1000.0, exact = std::asin(s) + s * std::sqrt(1 - s * s);
        CHECK(std::abs(s * (2 - 0.42920367 * s * s) - exact) <= 0.028);
    }
}
