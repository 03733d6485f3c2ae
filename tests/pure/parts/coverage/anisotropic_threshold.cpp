// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

namespace {

using namespace crease;

using layered = effect<directions<4, 4>, stochastic_layers<4>, hbao, anisotropic_threshold>;
static_assert(layered::passes[0].stage == stage_kind::geometry);
static_assert(anisotropic_threshold::description.resources.empty() &&
              anisotropic_threshold::description.numbers.empty());
static_assert(!recipe("directions/single_layer/hbao/anisotropic_threshold")); // there is nothing to cover
static_assert(!recipe("directions/stochastic_layers/hbao/anisotropic_threshold/stratified"));

}

TEST_CASE("anisotropic_threshold takes the footprint along each axis") {
    CHECK(contains(layered::source<0>(), "log2(0.70710678 / max(width, vec3(greatest / 64.0)))"));
    CHECK(contains(layered::source<0>(), "uint crease_kept_samples(vec3 anchor)"));
    CHECK_FALSE(contains(layered::source<0>(), "length(dFdx(anchor))"));
    CHECK_FALSE(contains(layered::source<1>(), "crease_kept_samples")); // the capture alone asks for it
}
