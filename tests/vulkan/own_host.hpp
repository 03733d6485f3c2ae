// SPDX-License-Identifier: MIT
#pragma once

#include <crease/vulkan/host_device.hpp>
#include <crease/vulkan/host_image.hpp>
#include <crease/vulkan/owned.hpp>

#include <functional>
#include <string>
#include <vector>

using crease::vulkan::detail::blank;

/// A host with a device of its own, made without crease but for the validation of its calls.
class own_host {
public:
    own_host() {
        vkGetPhysicalDeviceFeatures(physical_, &features_);
        make_device();
        auto pool = blank<VkCommandPoolCreateInfo>(VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO);
        expect(vkCreateCommandPool(device_.handle, &pool, nullptr, &pool_));
    }
    ~own_host() {
        for (const auto& each : cleanup_)
            each();
        vkDestroyCommandPool(device_.handle, pool_, nullptr);
    }
    own_host(const own_host&) = delete;
    own_host& operator=(const own_host&) = delete;

    crease::vulkan::host_device described() const {
        return {.physical = physical_,
                .handle = device_.handle,
                .queue = queue_,
                .queue_family = 0,
                .api_version = VK_API_VERSION_1_1,
                .features = features_,
                .extensions = {}};
    }

    /// What validation has said since the last call.
    std::vector<std::string> messages() { return instance_.take_messages(); }

    /// An image of one layer that lives as long as the host.
    crease::vulkan::host_image make_image(VkFormat format, std::uint32_t width, std::uint32_t height,
                                          VkImageUsageFlags usage, VkImageAspectFlags seen) {
        auto info = blank<VkImageCreateInfo>(VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO);
        info.imageType = VK_IMAGE_TYPE_2D;
        info.format = format;
        info.extent = {width, height, 1};
        info.mipLevels = info.arrayLayers = 1;
        info.samples = VK_SAMPLE_COUNT_1_BIT;
        info.usage = usage;
        VkImage image;
        expect(vkCreateImage(device_.handle, &info, nullptr, &image));
        VkMemoryRequirements needs;
        vkGetImageMemoryRequirements(device_.handle, image, &needs);
        auto allocation = blank<VkMemoryAllocateInfo>(VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO);
        allocation.allocationSize = needs.size;
        while (!(needs.memoryTypeBits >> allocation.memoryTypeIndex & 1))
            ++allocation.memoryTypeIndex;
        VkDeviceMemory memory;
        expect(vkAllocateMemory(device_.handle, &allocation, nullptr, &memory));
        expect(vkBindImageMemory(device_.handle, image, memory, 0));
        auto viewed = blank<VkImageViewCreateInfo>(VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO);
        viewed.image = image;
        viewed.viewType = VK_IMAGE_VIEW_TYPE_2D;
        viewed.format = format;
        viewed.subresourceRange = {seen, 0, 1, 0, 1};
        VkImageView view;
        expect(vkCreateImageView(device_.handle, &viewed, nullptr, &view));
        cleanup_.push_back([device = device_.handle, image, memory, view] {
            vkDestroyImageView(device, view, nullptr);
            vkDestroyImage(device, image, nullptr);
            vkFreeMemory(device, memory, nullptr);
        });
        return {.name = "the host's",
                .handle = image,
                .view = view,
                .format = format,
                .width = width,
                .height = height,
                .usage = usage};
    }

    /// A command buffer that is recorded now and submitted later.
    template <class Record>
    VkCommandBuffer recorded(Record record) {
        auto info = blank<VkCommandBufferAllocateInfo>(VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO);
        info.commandPool = pool_;
        info.commandBufferCount = 1;
        VkCommandBuffer commands;
        expect(vkAllocateCommandBuffers(device_.handle, &info, &commands));
        const auto begin = blank<VkCommandBufferBeginInfo>(VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO);
        expect(vkBeginCommandBuffer(commands, &begin));
        record(commands);
        expect(vkEndCommandBuffer(commands));
        return commands;
    }

    /// Submits all and then waits.
    void submit(const std::vector<VkCommandBuffer>& all) {
        for (const VkCommandBuffer& each : all) {
            auto info = blank<VkSubmitInfo>(VK_STRUCTURE_TYPE_SUBMIT_INFO);
            info.commandBufferCount = 1;
            info.pCommandBuffers = &each;
            expect(vkQueueSubmit(queue_, 1, &info, VK_NULL_HANDLE));
        }
        expect(vkQueueWaitIdle(queue_));
    }

private:
    crease::vulkan::detail::instance instance_{true};
    VkPhysicalDevice physical_ = instance_.devices().at(0);
    VkPhysicalDeviceFeatures features_{};
    crease::vulkan::detail::owned_device device_;
    VkQueue queue_ = VK_NULL_HANDLE;
    VkCommandPool pool_ = VK_NULL_HANDLE;
    std::vector<std::function<void()>> cleanup_;

    static void expect(VkResult result) { crease::vulkan::detail::check(result, "do what the test does"); }

    void make_device() {
        constexpr float priority = 1;
        auto queue = blank<VkDeviceQueueCreateInfo>(VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO);
        queue.queueCount = 1;
        queue.pQueuePriorities = &priority;
        auto info = blank<VkDeviceCreateInfo>(VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO);
        info.queueCreateInfoCount = 1;
        info.pQueueCreateInfos = &queue;
        info.pEnabledFeatures = &features_;
        expect(vkCreateDevice(physical_, &info, nullptr, &device_.handle));
        vkGetDeviceQueue(device_.handle, 0, 0, &queue_);
    }
};
