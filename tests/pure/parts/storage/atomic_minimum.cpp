// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

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
    for (const binding& b : captures.bindings)
        if (has_descriptor(b.how)) {
            CHECK(b.set == 1);
            CHECK(b.slot >= 20);
        }
    for (const constant& c : captures.constants)
        CHECK(c.id >= 30);
    for (const binding& b : layered::passes[1].bindings)
        CHECK(b.set == 0); // passes of the effect's own are not placed
}
