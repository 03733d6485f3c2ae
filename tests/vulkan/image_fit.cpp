// SPDX-License-Identifier: MIT
#include <crease/vulkan/image_fit.hpp>

#include "sentence.hpp"

#include <doctest/doctest.h>

using namespace crease;

namespace {

constexpr resource depth{.name = "depth", .texels = format::r32_float, .life = lifetime::input},
    visibility{.name = "visibility", .texels = format::r8_unorm, .life = lifetime::output};

constexpr VkImageUsageFlags sampled = VK_IMAGE_USAGE_SAMPLED_BIT, stored = VK_IMAGE_USAGE_STORAGE_BIT;

/// Nothing is done with the handles.
vulkan::host_image like(VkFormat format, std::uint32_t width, VkImageUsageFlags usage) {
    return {.name = "own",
            .handle = reinterpret_cast<VkImage>(std::uintptr_t{8}),
            .view = reinterpret_cast<VkImageView>(std::uintptr_t{8}),
            .format = format,
            .width = width,
            .height = 4,
            .usage = usage};
}

std::string said(const resource& wanted, const vulkan::host_image& given) {
    const VkImageUsageFlags usage = wanted.life == lifetime::input ? sampled : stored;
    return sentence_of([&] { vulkan::detail::expect_fit({wanted, {5, 4}, usage}, vulkan::image(given)); });
}

}

TEST_CASE("an input has any format that samples alike, and may be larger") {
    for (VkFormat format : {VK_FORMAT_R32_SFLOAT, VK_FORMAT_D32_SFLOAT, VK_FORMAT_D24_UNORM_S8_UINT,
                            VK_FORMAT_D16_UNORM, VK_FORMAT_R16_SFLOAT})
        for (std::uint32_t width : {5u, 9u})
            CHECK(said(depth, like(format, width, sampled | stored)) == "");
    CHECK(said(depth, like(VK_FORMAT_R32_UINT, 5, sampled)) ==
          "the image 'own' cannot be the input 'depth': it holds r32_uint, and may hold what samples as "
          "r32_float");
    CHECK(said(depth, like(VK_FORMAT_R16_SINT, 5, sampled)) ==
          "the image 'own' cannot be the input 'depth': it holds VkFormat 75, and may hold what samples as "
          "r32_float");
    CHECK(said(depth, like(VK_FORMAT_R32_SFLOAT, 4, sampled)) ==
          "the image 'own' cannot be the input 'depth': it is 4 x 4, and must be at least 5 x 4");
    CHECK(said(depth, like(VK_FORMAT_R32_SFLOAT, 5, stored)) ==
          "the image 'own' cannot be the input 'depth': it was not made for sampling");
}

TEST_CASE("an output is as it is declared") {
    CHECK(said(visibility, like(VK_FORMAT_R8_UNORM, 5, stored)) == "");
    CHECK(said(visibility, like(VK_FORMAT_R8G8B8A8_UNORM, 5, stored)) ==
          "the image 'own' cannot be the output 'visibility': it holds rgba8_unorm, and may hold r8_unorm");
    CHECK(said(visibility, like(VK_FORMAT_R8_UNORM, 6, stored)) ==
          "the image 'own' cannot be the output 'visibility': it is 6 x 4, and must be 5 x 4");
    CHECK(said(visibility, like(VK_FORMAT_R8_UNORM, 5, sampled)) ==
          "the image 'own' cannot be the output 'visibility': it was not made for storing");
    vulkan::host_image layered = like(VK_FORMAT_R8_UNORM, 5, stored);
    layered.layers = 2;
    CHECK(contains(said(visibility, layered), "it has 2 layers"));
}
