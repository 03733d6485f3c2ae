// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

namespace {

using namespace crease;

using layered = effect<directions<4, 4>, stochastic_layers<4>, hbao, simple_hash>;
static_assert(layered::passes[0].stage == stage_kind::geometry);
static_assert(simple_hash::description.resources.empty() && simple_hash::description.numbers.empty());
static_assert(!recipe("directions/single_layer/hbao/simple_hash")); // there is nothing to cover
static_assert(!recipe("directions/stochastic_layers/hbao/simple_hash/stratified"));

}

TEST_CASE("simple_hash tosses a coin for each sample by whole numbers") {
    CHECK(contains(layered::source<0>(), "salt * 0x85ebca6bu"));
    CHECK(contains(layered::source<0>(), "uint crease_kept_samples(vec3 anchor)"));
    CHECK_FALSE(contains(layered::source<0>(), "crease_hash_4d"));
    CHECK_FALSE(contains(layered::source<1>(), "crease_kept_samples")); // the capture alone asks for it
}
