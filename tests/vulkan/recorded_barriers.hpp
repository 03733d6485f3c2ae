// SPDX-License-Identifier: MIT
#pragma once

#include <vulkan/vulkan.h>

#include <cstddef>
#include <vector>

/// A barrier of one image, or where `image` is null one of all memory.
struct recorded_barrier {
    VkPipelineStageFlags from = 0, to = 0;
    VkAccessFlags written = 0, next = 0;
    VkImage image = VK_NULL_HANDLE;
    VkImageLayout before = VK_IMAGE_LAYOUT_UNDEFINED, after = VK_IMAGE_LAYOUT_UNDEFINED;

    /// Whether it waits for all of `stages`, and has what they wrote with `access` seen.
    bool waits_for(VkPipelineStageFlags stages, VkAccessFlags access) const {
        return (from & stages) == stages && (written & access) == access;
    }
    /// Whether all of `stages` wait for it, and see with `access` what was written.
    bool is_waited_for_by(VkPipelineStageFlags stages, VkAccessFlags access) const {
        return (to & stages) == stages && (next & access) == access;
    }
};

/// What this process records, in order, by vkCmdPipelineBarrier: validation does not know what the host
/// reads, nor all that a driver may reorder.
std::vector<recorded_barrier>& recorded_barriers();

/// Those of one image, after the first `from` of all.
std::vector<recorded_barrier> barriers_of(VkImage image, std::size_t from = 0);
