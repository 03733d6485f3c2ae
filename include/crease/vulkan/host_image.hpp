// SPDX-License-Identifier: MIT
#pragma once

#include <vulkan/vulkan.h>

#include <string>

namespace crease::vulkan {

/// An image of a host's own, which crease uses where it lies and does not destroy.
struct host_image {
    std::string name;                ///< in errors
    VkImage handle = VK_NULL_HANDLE; ///< the image itself
    VkImageView view =
        VK_NULL_HANDLE; ///< of level 0 and all layers; of depth alone, also where there is stencil
    VkFormat format = VK_FORMAT_UNDEFINED; ///< of the image and the view
    std::uint32_t width = 0;               ///< texels
    std::uint32_t height = 0;              ///< texels
    std::uint32_t layers = 1;              ///< array layers
    std::uint32_t samples = 1;             ///< samples of a texel
    bool arrayed = false;                  ///< the view is of an array, also where it has one layer
    VkImageUsageFlags usage = 0;           ///< that it was made for
};

}
