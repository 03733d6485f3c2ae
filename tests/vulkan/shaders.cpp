// SPDX-License-Identifier: MIT
#include <crease/vulkan/shaders.hpp>

#include "little_effect.hpp"
#include "sentence.hpp"

#include <doctest/doctest.h>

using namespace crease;

TEST_CASE(
    "an effect's shaders are one for each pass: with a vertex shader where it draws, none of geometry") {
    pass geometry = little::spread;
    geometry.stage = stage_kind::geometry;
    const pass passes[] = {little::scale, little::spread, geometry};
    effect_view effect = little::effect;
    effect.passes = passes;
    const std::vector<vulkan::pass_shaders> shaders = vulkan::compile(effect);
    REQUIRE(shaders.size() == 3);
    CHECK(!shaders[0].main.empty());
    CHECK(shaders[0].vertex.empty());
    CHECK(!shaders[1].main.empty());
    CHECK(!shaders[1].vertex.empty());
    CHECK(shaders[2].main.empty());
    CHECK(shaders[2].vertex.empty());
    CHECK(sentence_of([&] { vulkan::compile(geometry); }) ==
          "pass 'spread' is functions for the host's geometry: it has no main to compile");
}
