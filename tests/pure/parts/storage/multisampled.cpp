// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "placed.hpp"
#include "text.hpp"

#include <doctest/doctest.h>

#include <algorithm>

namespace {

using namespace crease;

using layered = effect<directions<4, 4>, stochastic_layers<6>, hbao, multisampled<1, 20, 30>>;
constexpr const pass& captures = layered::passes[0];
static_assert(captures.name == "capture_layers" && captures.stage == stage_kind::geometry);
static_assert(layered::passes[1].name == "pack_layers"); // reads at once what is captured
static_assert(!recipe("directions/single_layer/hbao/multisampled"));
static_assert(recipe("directions/stochastic_layers/hbao/multisampled:31x1023x1023"));
static_assert(!recipe("directions/stochastic_layers/hbao/multisampled:32"));
static_assert(captures.to_attachment() && captures.bindings.back().how == access::attachment);
static_assert(!layered::features.fragment_stores_and_atomics && layered::features.depth_samples == 8);
static_assert(layered::features.centred_depth_samples == 0);

}

TEST_CASE("multisampled draws to as many samples as it needs, each with the depth at the centre") {
    const auto r = std::ranges::find(layered::resources, "captured_layers", &resource::name);
    REQUIRE(r != layered::resources.end());
    CHECK(r->life == lifetime::transient);
    CHECK(r->size.guarded);
    CHECK(r->texels == format::d32_float);
    CHECK(r->samples == 8); // the next power of 2
    CHECK_FALSE(r->centred);
    CHECK_FALSE(r->cleared); // the render pass clears it
    CHECK(contains(layered::source<0>(), "void crease_capture(vec3 anchor)"));
    CHECK_FALSE(contains(layered::source<0>(), "void main()"));
    CHECK(contains(layered::source<0>(), "gl_FragDepth = gl_FragCoord.z;"));
    CHECK(contains(layered::source<0>(), "gl_SampleMask[0] = int(kept);"));
}

TEST_CASE("the numbers of multisampled place what the host's shader binds") {
    check_placed(captures, layered::passes[1]);
}
