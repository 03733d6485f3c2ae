// SPDX-License-Identifier: MIT
#pragma once

#include <crease/vulkan/error.hpp>

#include <utility>

namespace crease::vulkan::detail {

/// A Vulkan structure with its type set and all else zero.
template <class Info>
Info blank(VkStructureType type) {
    Info info{};
    info.sType = type;
    return info;
}

/// A Vulkan object that belongs to a device, and is destroyed with this.
template <class Handle, auto Destroy>
class owned {
public:
    using handle_type = Handle;

    owned() = default;
    owned(VkDevice device, Handle handle) : device_(device), handle_(handle) {}
    owned(owned&& other) noexcept : device_(other.device_), handle_(std::exchange(other.handle_, Handle{})) {}
    owned& operator=(owned&& other) noexcept {
        std::swap(device_, other.device_);
        std::swap(handle_, other.handle_);
        return *this;
    }
    ~owned() {
        if (handle_)
            Destroy(device_, handle_, nullptr);
    }

    operator Handle() const { return handle_; }

private:
    VkDevice device_ = VK_NULL_HANDLE;
    Handle handle_{};
};

/// A device itself, which is destroyed after all that belongs to it.
struct owned_device {
    VkDevice handle = VK_NULL_HANDLE;

    owned_device() = default;
    owned_device(const owned_device&) = delete;
    owned_device& operator=(const owned_device&) = delete;
    ~owned_device() {
        if (handle)
            vkDestroyDevice(handle, nullptr);
    }
};

using owned_memory = owned<VkDeviceMemory, vkFreeMemory>;
using owned_buffer = owned<VkBuffer, vkDestroyBuffer>;
using owned_image = owned<VkImage, vkDestroyImage>;
using owned_image_view = owned<VkImageView, vkDestroyImageView>;
using owned_sampler = owned<VkSampler, vkDestroySampler>;
using owned_shader_module = owned<VkShaderModule, vkDestroyShaderModule>;
using owned_set_layout = owned<VkDescriptorSetLayout, vkDestroyDescriptorSetLayout>;
using owned_descriptor_pool = owned<VkDescriptorPool, vkDestroyDescriptorPool>;
using owned_pipeline_layout = owned<VkPipelineLayout, vkDestroyPipelineLayout>;
using owned_pipeline = owned<VkPipeline, vkDestroyPipeline>;
using owned_render_pass = owned<VkRenderPass, vkDestroyRenderPass>;
using owned_framebuffer = owned<VkFramebuffer, vkDestroyFramebuffer>;
using owned_query_pool = owned<VkQueryPool, vkDestroyQueryPool>;
using owned_command_pool = owned<VkCommandPool, vkDestroyCommandPool>;
using owned_fence = owned<VkFence, vkDestroyFence>;

/// Makes an object by one of Vulkan's vkCreate functions, or one like them.
/// @param what  names the object in the error
template <class Owned, class Create, class Info>
Owned make(VkDevice device, Create create, const Info& info, const std::string& what) {
    typename Owned::handle_type handle{};
    check(create(device, &info, nullptr, &handle), "make " + what);
    return {device, handle};
}

}
