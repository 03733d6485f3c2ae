// SPDX-License-Identifier: MIT
#include <crease/vulkan/image.hpp>

#include "recorded_barriers.hpp"
#include "sentence.hpp"
#include "validated_device.hpp"

#include <doctest/doctest.h>

using namespace crease;

namespace {

constexpr VkImageUsageFlags copied = VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT;

vulkan::image_description described(format texels, std::uint32_t width, std::uint32_t height) {
    return {.name = "test", .texels = texels, .width = width, .height = height, .usage = copied};
}

}

TEST_CASE("what cannot be is said") {
    vulkan::device& device = validated_device();
    const auto said = [&](const vulkan::image_description& d) {
        return sentence_of([&] { vulkan::image(device, d); });
    };
    CHECK(said(described(format::r8_unorm, 0, 4)) == "the image 'test' of 0 x 4 r8_unorm has no texels");
    CHECK(contains(said(described(format::r8_unorm, 1u << 20, 1)),
                   "cannot hold the image 'test' of 1048576 x 1"));

    vulkan::image_description stored = described(format::d32_float, 4, 4);
    stored.usage = VK_IMAGE_USAGE_STORAGE_BIT;
    CHECK(contains(said(stored), "it has no such images for storing"));
    vulkan::image_description many = described(format::r8_unorm, 4, 4);
    many.layers = 1u << 20;
    CHECK(contains(said(many), "1048576 layers"));
    many.layers = 1;
    many.samples = 64;
    CHECK(contains(said(many), "64 samples"));
}

TEST_CASE("each level has a view and a use of its own") {
    vulkan::device& device = validated_device();
    vulkan::image_description d = described(format::r32_float, 8, 8);
    d.levels = 4;
    d.usage |= VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_STORAGE_BIT;
    vulkan::image image(device, d);
    CHECK(image.view(0) != image.view());
    CHECK(image.view(0) != image.view(3));
    constexpr VkPipelineStageFlags compute = VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT;
    const vulkan::image_use written{compute, VK_ACCESS_SHADER_WRITE_BIT, VK_IMAGE_LAYOUT_GENERAL, true};
    const vulkan::image_use read{compute, VK_ACCESS_SHADER_READ_BIT,
                                 VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
    const std::size_t from = recorded_barriers().size();
    device.submit([&](VkCommandBuffer commands) {
        image.transition(commands, written, 1);
        image.transition(commands, read, 1);
        image.transition(commands, read); // of the first, third and fourth alone
    });
    const std::vector<recorded_barrier> found = barriers_of(image.handle(), from);
    REQUIRE(found.size() == 5);
    CHECK(found[0].before == VK_IMAGE_LAYOUT_UNDEFINED);
    CHECK(found[1].before == VK_IMAGE_LAYOUT_GENERAL);
    for (std::size_t i = 2; i < 5; ++i)
        CHECK(found[i].before == VK_IMAGE_LAYOUT_UNDEFINED);

    vulkan::image_description plain = described(format::r32_float, 8, 8);
    plain.usage |= VK_IMAGE_USAGE_SAMPLED_BIT;
    vulkan::image one(device, plain);
    CHECK(one.levels() == 1);
    CHECK(one.view(0) == one.view());
}
