// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>
#include <crease/vulkan/runner.hpp>

#include "little_effect.hpp"
#include "recorded_barriers.hpp"
#include "sentence.hpp"
#include "sized.hpp"
#include "validated_device.hpp"

#include <doctest/doctest.h>

using namespace crease;

TEST_CASE("images are made in the sizes that are declared") {
    const recipe chosen("sample_box/mip_chain:3x4/mean_height/upsample:2");
    REQUIRE(chosen);
    const composition composed(chosen);
    vulkan::runner runner(validated_device(), composed, 45, 22, {.guard = 3, .constants = {}, .shaders = {}});
    const auto has = [&](std::string_view name, std::uint32_t width, std::uint32_t height,
                         std::uint32_t layers, bool arrayed) {
        CAPTURE(std::string(name));
        const vulkan::image_description& d = runner.image_of(name).description();
        CHECK(d.width == width);
        CHECK(d.height == height);
        CHECK(d.layers == layers);
        CHECK(d.samples == 1);
        CHECK(d.arrayed == arrayed);
    };
    has("odd_levels", 18, 12, 1, true);
    has("even_levels", 18, 12, 2, true); // 45 / 4 and 22 / 4 rounded up, and the band twice
    has("range_of_columns", 45, 1, 1, false);
    has("range", 1, 1, 1, false);
    has("between_0", 23, 11, 1, false);
    has("visibility", 45, 22, 1, false);
    const std::vector<float> depth(51 * 28, 0.5f);
    CHECK_NOTHROW(runner.upload("depth", std::span<const float>(depth)));
    has("depth", 51, 28, 1, false);
}

TEST_CASE("an image of another shape cannot be an input, and each difference counts") {
    vulkan::device& device = validated_device();
    vulkan::runner runner(device, little::effect, 5, 4);
    const vulkan::image_description fits{.name = "own",
                                         .texels = format::d32_float,
                                         .width = 5,
                                         .height = 4,
                                         .usage = VK_IMAGE_USAGE_SAMPLED_BIT};
    const auto refusal = [&](vulkan::image_description d) {
        vulkan::image image(device, d);
        return sentence_of([&] { runner.bind("depth", image); });
    };
    CHECK(refusal(fits) == "");
    vulkan::image_description other = fits;
    other.height = 3;
    CHECK(refusal(other) ==
          "the image 'own' cannot be the input 'depth': it is 5 x 3, and must be at least 5 x 4");
    other = fits;
    other.layers = 2;
    other.arrayed = true;
    CHECK(contains(refusal(other), "it has 2 layers"));
    other = fits;
    other.arrayed = true;
    CHECK(contains(refusal(other), "cannot be the input 'depth'"));
    other = fits;
    other.samples = 4;
    other.usage |= VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT;
    if (device.features().depth_samples & 4)
        CHECK(contains(refusal(other), "4 samples a texel"));
    else
        MESSAGE("the device lacks depth images of 4 samples: none is refused as an input on it");
}

TEST_CASE("the block is written after what reads the last one and before what reads it") {
    vulkan::runner runner(validated_device(), little::effect, 8, 8);
    runner.upload("depth", std::vector<float>(64, 1.0f));
    const std::size_t before = recorded_barriers().size();
    runner.run(sized(8, 8));
    const std::vector<recorded_barrier> of_memory = barriers_of(VK_NULL_HANDLE, before);
    constexpr VkPipelineStageFlags shaders =
        VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT | VK_PIPELINE_STAGE_FRAGMENT_SHADER_BIT;
    REQUIRE(of_memory.size() == 2);
    CHECK(of_memory[0].waits_for(shaders, 0));
    CHECK(of_memory[0].is_waited_for_by(VK_PIPELINE_STAGE_TRANSFER_BIT, VK_ACCESS_TRANSFER_WRITE_BIT));
    CHECK(of_memory[1].waits_for(VK_PIPELINE_STAGE_TRANSFER_BIT, VK_ACCESS_TRANSFER_WRITE_BIT));
    CHECK(of_memory[1].is_waited_for_by(shaders, VK_ACCESS_UNIFORM_READ_BIT));
}
