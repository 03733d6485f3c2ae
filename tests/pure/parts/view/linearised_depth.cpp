// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

using namespace crease;

TEST_CASE("linearised_depth stores linear depth first, from which all other passes read") {
    using effect = crease::effect<directions<>, single_layer, hbao, upsample<2>, linearised_depth>;
    const auto& [linearise, main, up] = effect::passes;
    CHECK(linearise.name == "linearise");
    CHECK(linearise.bindings[1].name == "depth");
    CHECK(linearise.bindings[1].how == access::sample);
    CHECK(linearise.bindings[2].how == access::store);
    CHECK(contains(effect::source<0>(), "uniform sampler2D crease_depth;\n"));
    for (const pass* each : {&main, &up}) {
        const binding& depth = each->bindings[1];
        CHECK(depth.name == "linearised_depth");
        CHECK_FALSE(writes(depth.how));
    }
    CHECK_FALSE(contains(effect::source<1>(), "sampler2D crease_depth;"));
    CHECK(contains(effect::source<1>(), "uniform sampler2D crease_linearised_depth;\n"));
}

TEST_CASE("images that are loaded and stored share the units of OpenGL") {
    using effect =
        crease::effect<directions<>, single_layer, hbao, linearised_depth, image_load, opengl_glsl>;
    CHECK(contains(effect::source<1>(), "layout(r32f, binding = 0) uniform readonly image2D"));
    CHECK(contains(effect::source<1>(), "layout(r8, binding = 1) uniform writeonly image2D"));
}
