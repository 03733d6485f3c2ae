// SPDX-License-Identifier: MIT
#include "recorded_barriers.hpp"

#include <dlfcn.h>

#include <cstdint>

std::vector<recorded_barrier>& recorded_barriers() {
    static std::vector<recorded_barrier> all;
    return all;
}

std::vector<recorded_barrier> barriers_of(VkImage image, std::size_t from) {
    std::vector<recorded_barrier> found;
    for (std::size_t i = from; i < recorded_barriers().size(); ++i)
        if (recorded_barriers()[i].image == image)
            found.push_back(recorded_barriers()[i]);
    return found;
}

/// Stands before the loader's function of that name, and calls it.
extern "C" VKAPI_ATTR void VKAPI_CALL vkCmdPipelineBarrier(
    VkCommandBuffer commands, VkPipelineStageFlags from, VkPipelineStageFlags to, VkDependencyFlags flags,
    std::uint32_t memory_count, const VkMemoryBarrier* memory, std::uint32_t buffer_count,
    const VkBufferMemoryBarrier* buffers, std::uint32_t image_count, const VkImageMemoryBarrier* images) {
    static const auto loaders =
        reinterpret_cast<PFN_vkCmdPipelineBarrier>(dlsym(RTLD_NEXT, "vkCmdPipelineBarrier"));
    for (std::uint32_t i = 0; i < memory_count; ++i)
        recorded_barriers().push_back({from, to, memory[i].srcAccessMask, memory[i].dstAccessMask});
    for (std::uint32_t i = 0; i < image_count; ++i)
        recorded_barriers().push_back({from, to, images[i].srcAccessMask, images[i].dstAccessMask,
                                       images[i].image, images[i].oldLayout, images[i].newLayout});
    loaders(commands, from, to, flags, memory_count, memory, buffer_count, buffers, image_count, images);
}
