// SPDX-License-Identifier: MIT
#include <crease/vulkan/formats.hpp>

using namespace crease;
using namespace crease::vulkan::detail;

namespace {

/// The other way round for each format that crease has, and what it says of whole numbers.
constexpr bool each_is_named() {
    for (std::size_t i = 1; i < std::size(facts_of_formats); ++i) {
        const auto f = static_cast<format>(i);
        if (named(texel_of(f).format) != f ||
            holds_whole_numbers(texel_of(f).format) != facts_of(f).whole_numbers)
            return false;
    }
    return true;
}
static_assert(each_is_named());
static_assert(named(VK_FORMAT_D16_UNORM) == format::none && named(VK_FORMAT_UNDEFINED) == format::none);

// Vulkan lists its formats by size, each as UNORM, SNORM, USCALED, SSCALED, UINT, SINT and then others.
constexpr bool each_of_seven(int first, int last) {
    for (int f = first; f <= last; ++f)
        if (holds_whole_numbers(static_cast<VkFormat>(f)) != ((f - first) % 7 == 4 || (f - first) % 7 == 5))
            return false;
    return true;
}
static_assert(each_of_seven(VK_FORMAT_R8_UNORM, VK_FORMAT_A8B8G8R8_SRGB_PACK32)); // the seventh is SRGB
static_assert(each_of_seven(VK_FORMAT_R16_UNORM, VK_FORMAT_R16G16B16A16_SFLOAT)); // the seventh is SFLOAT
static_assert(holds_whole_numbers(VK_FORMAT_A2B10G10R10_UINT_PACK32) &&
              !holds_whole_numbers(VK_FORMAT_A2B10G10R10_UNORM_PACK32));
static_assert(!holds_whole_numbers(VK_FORMAT_B10G11R11_UFLOAT_PACK32) &&
              !holds_whole_numbers(VK_FORMAT_D24_UNORM_S8_UINT));

static_assert(aspects_of(VK_FORMAT_D24_UNORM_S8_UINT) ==
              (VK_IMAGE_ASPECT_DEPTH_BIT | VK_IMAGE_ASPECT_STENCIL_BIT));
static_assert(aspects_of(VK_FORMAT_D16_UNORM) == VK_IMAGE_ASPECT_DEPTH_BIT);
static_assert(aspects_of(VK_FORMAT_R8_UNORM) == VK_IMAGE_ASPECT_COLOR_BIT);

}
