// SPDX-License-Identifier: MIT
#include <crease/vulkan/copy.hpp>

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

    vulkan::image image(device, described(format::r32_float, 7, 5));
    const std::vector<float> few(34);
    CHECK(sentence_of([&] { vulkan::upload(device, image, std::span<const float>(few)); }) ==
          "the image 'test' takes 35 numbers, not 34");
}

TEST_CASE("too little memory: the object and its bytes are named") {
    vulkan::device device; // validation warns of such sizes first
    const std::string said = sentence_of([&] {
        vulkan::buffer(device, std::size_t{1} << 44, VK_BUFFER_USAGE_TRANSFER_SRC_BIT,
                       vulkan::transfer::to_device, "huge");
    });
    CHECK(contains(said, "the buffer 'huge' of 17592186044416 bytes"));
    CHECK(contains(said, "out of "));
}
