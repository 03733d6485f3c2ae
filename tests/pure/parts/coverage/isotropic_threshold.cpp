// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

namespace {

using namespace crease;

using layered = effect<directions<4, 4>, stochastic_layers<4>, hbao, isotropic_threshold>;
static_assert(layered::passes[0].stage == stage_kind::geometry);
static_assert(isotropic_threshold::description.resources.empty() &&
              isotropic_threshold::description.numbers.empty());
static_assert(!recipe("directions/single_layer/hbao/isotropic_threshold")); // there is nothing to cover
static_assert(!recipe("directions/stochastic_layers/hbao/isotropic_threshold/stratified"));

}

TEST_CASE("isotropic_threshold takes the longer side of a texel's footprint") {
    CHECK(contains(layered::source<0>(), "max(length(dFdx(anchor)), length(dFdy(anchor)))"));
    CHECK(contains(layered::source<0>(), "uint crease_kept_samples(vec3 anchor)"));
    CHECK_FALSE(contains(layered::source<0>(), "0.70710678"));
    CHECK_FALSE(contains(layered::source<1>(), "crease_kept_samples")); // the capture alone asks for it
}
