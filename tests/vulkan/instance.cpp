// SPDX-License-Identifier: MIT
#include <crease/vulkan/runner.hpp>

#include "environment.hpp"
#include "little_effect.hpp"
#include "sentence.hpp"
#include "sized.hpp"

#include <doctest/doctest.h>

#include <span>

using namespace crease;

TEST_CASE("no validation layer") {
    const environment nowhere("VK_LAYER_PATH", "/nowhere");
    CHECK(sentence_of([] { vulkan::device({.name = {}, .validation = true}); }) ==
          "validation was asked for, but there is no layer VK_LAYER_KHRONOS_validation");
    CHECK_NOTHROW(vulkan::device());
}

// The tests' validation sees more than the arguments of calls.
TEST_CASE("a shader that reads beyond its block is seen, as validation is assisted by the device") {
    const piece longer{"block.glsl", "layout(std140, set = 0, binding = 0) uniform crease_parameters { vec4 "
                                     "crease_numbers[1000]; };\n"};
    const piece beyond{"beyond.glsl", R"(
void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (all(lessThan(at, imageSize(crease_output))))
        imageStore(crease_output, at, crease_numbers[int(texelFetch(crease_depth, at, 0).x)]);
}
)"};
    const piece pieces[] = {little::version, longer, little::scale_interface, beyond};
    pass passes[] = {little::scale, little::spread};
    passes[0].pieces = pieces;
    effect_view effect = little::effect;
    effect.passes = passes;
    vulkan::device device({.name = {}, .validation = true});
    vulkan::runner runner(device, effect, 4, 4);
    const auto said = [&](float index) {
        const std::vector<float> depth(16, index);
        runner.upload("depth", std::span<const float>(depth));
        return sentence_of([&] { runner.run(sized(4, 4)); });
    };
    const auto rows = static_cast<float>(effect.block_size() / 16);
    CHECK(said(rows - 1) == "");
    CHECK(contains(said(rows), "access out of bounds"));
}
