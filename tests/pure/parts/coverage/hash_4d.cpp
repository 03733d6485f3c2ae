// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

namespace {

using namespace crease;

using layered = effect<directions<4, 4>, stochastic_layers<4>, hbao, hash_4d>;
static_assert(layered::passes[0].stage == stage_kind::geometry);
static_assert(hash_4d::description.resources.empty() && hash_4d::description.numbers.empty());
static_assert(!recipe("directions/single_layer/hbao/hash_4d")); // there is nothing to cover
static_assert(!recipe("directions/stochastic_layers/hbao/hash_4d/stratified"));

}

TEST_CASE("hash_4d nests the hash of a plane") {
    CHECK(contains(layered::source<0>(), "fract(1.0e4 * sin(17.0 * v.x + 0.1 * v.y)"));
    CHECK(contains(layered::source<0>(), "uint crease_kept_samples(vec3 anchor)"));
    CHECK_FALSE(contains(layered::source<0>(), "crease_fragment_noise"));
    CHECK_FALSE(contains(layered::source<1>(), "crease_kept_samples")); // the capture alone asks for it
}
