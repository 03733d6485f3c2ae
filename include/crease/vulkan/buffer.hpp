// SPDX-License-Identifier: MIT
#pragma once

#include <crease/vulkan/memory.hpp>

#include <cstddef>
#include <span>

namespace crease::vulkan {

/// Which way a buffer's bytes go.
enum class transfer : unsigned char {
    to_device,  ///< written by the host
    from_device ///< read by the host
};

/// A buffer that the host sees.
class buffer {
public:
    /// @param bytes  > 0
    /// @param name   names the buffer in errors
    /// @throws error  where there is not enough memory
    buffer(const device& on, std::size_t bytes, VkBufferUsageFlags usage, transfer way,
           const std::string& name)
        : size_(bytes) {
        auto info = detail::blank<VkBufferCreateInfo>(VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO);
        info.size = bytes;
        info.usage = usage;
        info.sharingMode = VK_SHARING_MODE_EXCLUSIVE;
        const std::string what = "the buffer '" + name + "' of " + std::to_string(bytes) + " bytes";
        handle_ = detail::make<detail::owned_buffer>(on.handle(), vkCreateBuffer, info, what);
        VkMemoryRequirements needs;
        vkGetBufferMemoryRequirements(on.handle(), handle_, &needs);
        constexpr VkMemoryPropertyFlags wanted =
            VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
        // What the host reads must be cached, or reading it is very slow.
        const VkMemoryPropertyFlags preferred = way == transfer::to_device
                                                    ? VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT
                                                    : VK_MEMORY_PROPERTY_HOST_CACHED_BIT;
        memory_ = detail::allocate(on, needs, wanted, preferred, what);
        detail::check(vkBindBufferMemory(on.handle(), handle_, memory_, 0), "bind " + what);
        void* mapped;
        detail::check(vkMapMemory(on.handle(), memory_, 0, VK_WHOLE_SIZE, 0, &mapped), "map " + what);
        mapped_ = static_cast<std::byte*>(mapped);
    }

    /// The buffer itself.
    VkBuffer handle() const { return handle_; }

    /// Its content. The host must not touch it while the device uses it.
    std::span<std::byte> bytes() const { return {mapped_, size_}; }

private:
    std::size_t size_;
    detail::owned_memory memory_;
    detail::owned_buffer handle_;
    std::byte* mapped_ = nullptr;
};

}

namespace crease::vulkan::detail {

/// Records that all memory which `from` wrote by `written` is seen by `to` that touch it by `next`.
inline void memory_barrier(VkCommandBuffer commands, VkPipelineStageFlags from, VkAccessFlags written,
                           VkPipelineStageFlags to, VkAccessFlags next) {
    auto barrier = blank<VkMemoryBarrier>(VK_STRUCTURE_TYPE_MEMORY_BARRIER);
    barrier.srcAccessMask = written;
    barrier.dstAccessMask = next;
    vkCmdPipelineBarrier(commands, from, to, 0, 1, &barrier, 0, nullptr, 0, nullptr);
}

}
