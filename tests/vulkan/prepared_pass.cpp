// SPDX-License-Identifier: MIT
#include <crease/vulkan/runner.hpp>

#include "little_effect.hpp"
#include "sentence.hpp"
#include "validated_device.hpp"

#include <doctest/doctest.h>

using namespace crease;

TEST_CASE("workgroups that the device cannot run are refused") {
    vulkan::device& device = validated_device();
    const auto said = [&](int width, int height) {
        return sentence_of([&] {
            vulkan::runner(
                device, little::effect, 4, 4,
                {.constants = {{"compute.width", width}, {"compute.height", height}}, .shaders = {}});
        });
    };
    const auto refusal = [&](const std::string& size) {
        return "pass 'scale' wants workgroups of " + size + ", which the device '" + device.name() +
               "' cannot run";
    };
    CHECK(said(8, 4) == "");
    CHECK(said(0, 4) == refusal("0 x 4"));
    CHECK(said(8, -1) == refusal("8 x -1"));
    CHECK(said(100000, 4) == refusal("100000 x 4"));
    // Each axis may be as long, but not both.
    const auto most = static_cast<int>(device.limits().maxComputeWorkGroupInvocations);
    CHECK(said(most, 2) == refusal(std::to_string(most) + " x 2"));
}
