// SPDX-License-Identifier: MIT
#pragma once

#include <vulkan/vulkan.h>

// What a designated initialiser leaves out is zero, as Vulkan wants it.
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"

/// How commands use an image.
struct image_use {
    VkImageLayout layout = VK_IMAGE_LAYOUT_UNDEFINED;
    VkPipelineStageFlags stage = VK_PIPELINE_STAGE_TOP_OF_PIPE_BIT;
    VkAccessFlags access = 0;
};

inline constexpr image_use copy_target{VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, VK_PIPELINE_STAGE_TRANSFER_BIT,
                                       VK_ACCESS_TRANSFER_WRITE_BIT};
inline constexpr image_use copy_source{VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, VK_PIPELINE_STAGE_TRANSFER_BIT,
                                       VK_ACCESS_TRANSFER_READ_BIT};
inline constexpr image_use depth_target{
    VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL,
    VK_PIPELINE_STAGE_EARLY_FRAGMENT_TESTS_BIT | VK_PIPELINE_STAGE_LATE_FRAGMENT_TESTS_BIT,
    VK_ACCESS_DEPTH_STENCIL_ATTACHMENT_READ_BIT | VK_ACCESS_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT};

/// The engine's image, which knows its last use, as the next one must wait for that.
struct image {
    VkImage handle;
    VkImageView view;
    VkImageSubresourceRange range;
    VkExtent3D size;
    image_use last{};

    void change(VkCommandBuffer commands, const image_use& next) {
        const VkImageMemoryBarrier barrier{.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER,
                                           .srcAccessMask = last.access,
                                           .dstAccessMask = next.access,
                                           .oldLayout = last.layout,
                                           .newLayout = next.layout,
                                           .srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
                                           .dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
                                           .image = handle,
                                           .subresourceRange = range};
        vkCmdPipelineBarrier(commands, last.stage, next.stage, 0, 0, nullptr, 0, nullptr, 1, &barrier);
        last = next;
    }
};
