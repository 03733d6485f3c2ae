// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "placed.hpp"
#include "text.hpp"

#include <doctest/doctest.h>

#include <algorithm>

namespace {

using namespace crease;

using layered = effect<directions<4, 4>, stochastic_layers<6>, hbao, atomic_minimum<1, 20, 30>>;
constexpr const pass& captures = layered::passes[0];
static_assert(captures.name == "capture_layers" && captures.stage == stage_kind::geometry);
static_assert(layered::passes[1].name == "pack_layers"); // reads at once what is captured
static_assert(!recipe("directions/single_layer/hbao/atomic_minimum"));
static_assert(recipe("directions/stochastic_layers/hbao/atomic_minimum:31x1023x1023"));
static_assert(!recipe("directions/stochastic_layers/hbao/atomic_minimum:32"));
static_assert(!captures.to_attachment() && captures.bindings.back().how == access::modify);
static_assert(layered::features.fragment_stores_and_atomics && layered::features.depth_samples == 0);
static_assert(!effect<directions<4, 4>, stochastic_layers<6>, hbao, atomic_minimum<>,
                      opengl_glsl>::features.fragment_stores_and_atomics); // OpenGL 4.3 has them

}

TEST_CASE("atomic_minimum clears an image of as many layers as there are samples, and keeps the least bits") {
    const auto r = std::ranges::find(layered::resources, "captured_layers", &resource::name);
    REQUIRE(r != layered::resources.end());
    CHECK(r->life == lifetime::transient);
    CHECK(r->size.guarded);
    CHECK(r->texels == format::r32_uint);
    CHECK(r->layers == 6);
    CHECK(r->arrayed);
    CHECK(r->samples == 1);
    CHECK(r->cleared);
    CHECK(r->clear == ~0u); // a NaN, greater than all bits of depths
    CHECK(contains(layered::source<0>(), "void crease_capture(vec3 anchor)"));
    CHECK_FALSE(contains(layered::source<0>(), "void main()"));
    CHECK(contains(layered::source<0>(), "imageAtomicMin(crease_captured_layers, ivec3(gl_FragCoord.xy"));
}

TEST_CASE("the numbers of atomic_minimum place what the host's shader binds") {
    check_placed(captures, layered::passes[1]);
}
