// SPDX-License-Identifier: MIT
#include <crease/vulkan/image.hpp>

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
