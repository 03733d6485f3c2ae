// SPDX-License-Identifier: MIT
#include <crease/vulkan/copy.hpp>

#include "recorded_barriers.hpp"
#include "sentence.hpp"
#include "validated_device.hpp"

#include <doctest/doctest.h>

#include <span>

using namespace crease;

namespace {

constexpr VkImageUsageFlags copied = VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT;

vulkan::image_description described(format texels, std::uint32_t width, std::uint32_t height) {
    return {.name = "test", .texels = texels, .width = width, .height = height, .usage = copied};
}

}

TEST_CASE("what is uploaded is downloaded") {
    vulkan::device& device = validated_device();
    for (const auto& [width, height] : {std::pair(1u, 1u), std::pair(7u, 5u), std::pair(641u, 359u)})
        for (format texels : {format::r8_unorm, format::rgba8_unorm, format::r32_float, format::rgba16_float,
                              format::d32_float}) {
            vulkan::image image(device, described(texels, width, height));
            std::vector<float> numbers(std::size_t{width} * height *
                                       vulkan::detail::texel_of(texels).components);
            for (std::size_t i = 0; i < numbers.size(); ++i)
                numbers[i] = static_cast<float>(i % 256) / 255;
            if (texels == format::rgba16_float)
                for (float& number : numbers)
                    number = vulkan::detail::float_of_half(vulkan::detail::half_of(number));
            vulkan::upload(device, image, std::span<const float>(numbers));
            CHECK(vulkan::download(device, image) == numbers);
        }
}

TEST_CASE("layers and whole numbers") {
    vulkan::device& device = validated_device();
    vulkan::image_description d = described(format::r32_uint, 3, 2);
    d.layers = 4;
    vulkan::image image(device, d);
    std::vector<std::uint32_t> numbers(24);
    for (std::uint32_t i = 0; i < 24; ++i)
        numbers[i] = 0xffffffffu - i;
    vulkan::upload(device, image, std::span<const std::uint32_t>(numbers));
    CHECK(vulkan::download_uint(device, image) == numbers);
    CHECK(contains(sentence_of([&] { vulkan::download(device, image); }), "download_uint"));
}

TEST_CASE("numbers of another count or type are refused") {
    vulkan::device& device = validated_device();
    vulkan::image image(device, described(format::r32_float, 7, 5));
    CHECK(sentence_of([&] { vulkan::upload(device, image, std::vector<float>(34)); }) ==
          "the image 'test' takes 35 numbers, not 34");
    CHECK(sentence_of([&] { vulkan::upload(device, image, std::vector<std::byte>(139)); }) ==
          "the image 'test' takes 140 bytes, not 139");
    CHECK(sentence_of([&] { vulkan::upload(device, image, std::vector<std::uint32_t>(35)); }) ==
          "the image 'test' holds r32_float, not r32_uint");
    CHECK(sentence_of([&] { vulkan::download_uint(device, image); }) ==
          "the image 'test' holds r32_float, not r32_uint");
}

TEST_CASE("what is downloaded is written before the host reads it") {
    vulkan::device& device = validated_device();
    vulkan::image image(device, {.name = "test",
                                 .texels = format::r8_unorm,
                                 .width = 3,
                                 .height = 2,
                                 .usage = VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT});
    const std::vector<float> numbers{0, 1, 0, 1, 1, 0};
    vulkan::upload(device, image, std::span<const float>(numbers));
    CHECK(vulkan::download(device, image) == numbers);
    const auto of_image = barriers_of(image.handle());
    REQUIRE(of_image.size() == 2);
    CHECK(of_image[1].waits_for(VK_PIPELINE_STAGE_TRANSFER_BIT, VK_ACCESS_TRANSFER_WRITE_BIT));
    CHECK(of_image[1].is_waited_for_by(VK_PIPELINE_STAGE_TRANSFER_BIT, VK_ACCESS_TRANSFER_READ_BIT));
    const recorded_barrier& last = recorded_barriers().back();
    CHECK(last.image == VK_NULL_HANDLE);
    CHECK(last.waits_for(VK_PIPELINE_STAGE_TRANSFER_BIT, VK_ACCESS_TRANSFER_WRITE_BIT));
    CHECK(last.is_waited_for_by(VK_PIPELINE_STAGE_HOST_BIT, VK_ACCESS_HOST_READ_BIT));
}

TEST_CASE("levels follow one another, each half as large, and there are no more than the size has") {
    vulkan::device& device = validated_device();
    vulkan::image_description d = described(format::r32_float, 5, 3);
    d.layers = 2;
    d.levels = 16;
    vulkan::image image(device, d);
    CHECK(image.levels() == 3);
    std::vector<float> numbers(2 * (5 * 3 + 2 * 1 + 1));
    for (std::size_t i = 0; i < numbers.size(); ++i)
        numbers[i] = static_cast<float>(i);
    vulkan::upload(device, image, std::span<const float>(numbers));
    CHECK(vulkan::download(device, image) == numbers);
    CHECK(sentence_of([&] { vulkan::upload(device, image, std::vector<float>(30)); }) ==
          "the image 'test' takes 36 numbers, not 30");
}
