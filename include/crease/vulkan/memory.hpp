// SPDX-License-Identifier: MIT
#pragma once

#include <crease/vulkan/device.hpp>

namespace crease::vulkan::detail {

/// Allocates memory for one object: of the first type that has `wanted` and `preferred`, else of one with
/// `wanted`.
/// @param what  names the object in the error
/// @throws error  where there is not enough, with the bytes asked for
inline owned_memory allocate(const device& on, const VkMemoryRequirements& needs,
                             VkMemoryPropertyFlags wanted, VkMemoryPropertyFlags preferred,
                             const std::string& what) {
    VkPhysicalDeviceMemoryProperties memory;
    vkGetPhysicalDeviceMemoryProperties(on.physical(), &memory);
    auto info = blank<VkMemoryAllocateInfo>(VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO);
    info.allocationSize = needs.size;
    for (const VkMemoryPropertyFlags properties : {wanted | preferred, wanted})
        for (std::uint32_t type = 0; type < memory.memoryTypeCount; ++type) {
            const bool fits = needs.memoryTypeBits & (1u << type);
            if (!fits || (memory.memoryTypes[type].propertyFlags & properties) != properties)
                continue;
            info.memoryTypeIndex = type;
            VkDeviceMemory allocated;
            if (vkAllocateMemory(on.handle(), &info, nullptr, &allocated) == VK_SUCCESS)
                return {on.handle(), allocated};
        }
    throw error("out of memory: " + what + " needs " + std::to_string(needs.size) + " bytes on '" +
                on.name() + "'");
}

}
