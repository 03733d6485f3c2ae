// SPDX-License-Identifier: MIT
#pragma once

#include "image.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <deque>
#include <functional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

/// The engine's own renderer, which knows nothing of crease: a device, memory and one queue.
class renderer {
public:
    /// @param wanted  features that the device must have
    /// @throws std::runtime_error  where there is no such device
    explicit renderer(const VkPhysicalDeviceFeatures& wanted) {
        make_instance();
        choose_device(wanted);
        make_device(wanted);
    }
    renderer(const renderer&) = delete;
    renderer& operator=(const renderer&) = delete;
    ~renderer() {
        while (!cleanup_.empty()) {
            cleanup_.back()();
            cleanup_.pop_back();
        }
    }

    static void check(VkResult result, const char* what) {
        if (result != VK_SUCCESS)
            throw std::runtime_error(std::string(what) + " fails, VkResult " + std::to_string(result));
    }

    VkPhysicalDevice physical() const { return physical_; }
    VkDevice device() const { return device_; }
    VkQueue queue() const { return queue_; }
    std::uint32_t queue_family() const { return family_; }

    /// Makes an object that lives as long as the renderer: make<VkSampler>(vkCreateSampler, info,
    /// vkDestroySampler).
    template <class Handle, class Create, class Info, class Destroy>
    Handle make(Create create, const Info& info, Destroy destroy) {
        Handle handle{};
        check(create(device_, &info, nullptr, &handle), "creating a Vulkan object");
        cleanup_.push_back([device = device_, destroy, handle] { destroy(device, handle, nullptr); });
        return handle;
    }

    /// A stage of a pipeline, from SPIR-V.
    VkPipelineShaderStageCreateInfo make_shader(VkShaderStageFlagBits stage,
                                                std::span<const std::uint32_t> words) {
        const VkShaderModuleCreateInfo info{.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO,
                                            .codeSize = words.size_bytes(),
                                            .pCode = words.data()};
        return {.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO,
                .stage = stage,
                .module = make<VkShaderModule>(vkCreateShaderModule, info, vkDestroyShaderModule),
                .pName = "main"};
    }

    struct mapped_buffer {
        VkBuffer handle;
        void* bytes;
    };

    mapped_buffer make_buffer(VkDeviceSize size, VkBufferUsageFlags usage) {
        const VkBufferCreateInfo info{
            .sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO, .size = size, .usage = usage};
        const auto handle = make<VkBuffer>(vkCreateBuffer, info, vkDestroyBuffer);
        VkMemoryRequirements needs;
        vkGetBufferMemoryRequirements(device_, handle, &needs);
        const VkDeviceMemory memory =
            allocate(needs, VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT);
        check(vkBindBufferMemory(device_, handle, memory, 0), "binding memory");
        void* bytes = nullptr;
        check(vkMapMemory(device_, memory, 0, size, 0, &bytes), "mapping memory");
        return {handle, bytes};
    }

    /// @param layers  of an array image; 0: it is none
    image& make_image(VkExtent2D size, VkFormat format, VkImageUsageFlags usage, VkImageAspectFlags aspect,
                      std::uint32_t layers = 0) {
        const VkImageCreateInfo info{.sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO,
                                     .imageType = VK_IMAGE_TYPE_2D,
                                     .format = format,
                                     .extent = {size.width, size.height, 1},
                                     .mipLevels = 1,
                                     .arrayLayers = std::max(layers, 1u),
                                     .samples = VK_SAMPLE_COUNT_1_BIT,
                                     .usage = usage};
        image made{.handle = make<VkImage>(vkCreateImage, info, vkDestroyImage),
                   .range = {aspect, 0, 1, 0, info.arrayLayers},
                   .size = info.extent};
        VkMemoryRequirements needs;
        vkGetImageMemoryRequirements(device_, made.handle, &needs);
        check(vkBindImageMemory(device_, made.handle, allocate(needs, 0), 0), "binding memory");
        const VkImageViewCreateInfo view{.sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO,
                                         .image = made.handle,
                                         .viewType = layers == 0 ? VK_IMAGE_VIEW_TYPE_2D
                                                                 : VK_IMAGE_VIEW_TYPE_2D_ARRAY,
                                         .format = format,
                                         .subresourceRange = made.range};
        made.view = make<VkImageView>(vkCreateImageView, view, vkDestroyImageView);
        return images_.emplace_back(made);
    }

    /// Fills an image of one layer.
    void upload(image& to, std::span<const std::byte> texels) {
        const mapped_buffer from = make_buffer(texels.size(), VK_BUFFER_USAGE_TRANSFER_SRC_BIT);
        std::memcpy(from.bytes, texels.data(), texels.size());
        run([&](VkCommandBuffer commands) {
            const VkBufferImageCopy whole = whole_of(to);
            to.change(commands, copy_target);
            vkCmdCopyBufferToImage(commands, from.handle, to.handle, copy_target.layout, 1, &whole);
        });
    }

    /// The texels of an image of one byte each.
    std::vector<std::uint8_t> download(image& from) {
        const std::size_t count = std::size_t{from.size.width} * from.size.height;
        const mapped_buffer to = make_buffer(count, VK_BUFFER_USAGE_TRANSFER_DST_BIT);
        run([&](VkCommandBuffer commands) {
            const VkBufferImageCopy whole = whole_of(from);
            from.change(commands, copy_source);
            vkCmdCopyImageToBuffer(commands, from.handle, copy_source.layout, to.handle, 1, &whole);
            const VkMemoryBarrier to_host{.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER,
                                          .srcAccessMask = VK_ACCESS_TRANSFER_WRITE_BIT,
                                          .dstAccessMask = VK_ACCESS_HOST_READ_BIT};
            vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_TRANSFER_BIT, VK_PIPELINE_STAGE_HOST_BIT, 0, 1,
                                 &to_host, 0, nullptr, 0, nullptr);
        });
        const auto* texels = static_cast<const std::uint8_t*>(to.bytes);
        return {texels, texels + count};
    }

    /// Records commands, submits them and waits until they are done.
    void run(const std::function<void(VkCommandBuffer)>& record) {
        const VkCommandPoolCreateInfo pool_info{.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO,
                                                .queueFamilyIndex = family_};
        const auto pool = make<VkCommandPool>(vkCreateCommandPool, pool_info, vkDestroyCommandPool);
        const VkCommandBufferAllocateInfo info{.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO,
                                               .commandPool = pool,
                                               .level = VK_COMMAND_BUFFER_LEVEL_PRIMARY,
                                               .commandBufferCount = 1};
        VkCommandBuffer commands;
        check(vkAllocateCommandBuffers(device_, &info, &commands), "allocating a command buffer");
        const VkCommandBufferBeginInfo begin{.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
        check(vkBeginCommandBuffer(commands, &begin), "recording");
        record(commands);
        check(vkEndCommandBuffer(commands), "recording");
        const VkSubmitInfo submit{
            .sType = VK_STRUCTURE_TYPE_SUBMIT_INFO, .commandBufferCount = 1, .pCommandBuffers = &commands};
        check(vkQueueSubmit(queue_, 1, &submit, VK_NULL_HANDLE), "submitting");
        check(vkQueueWaitIdle(queue_), "waiting for the device");
    }

private:
    static VkBufferImageCopy whole_of(const image& of) {
        return {.imageSubresource = {of.range.aspectMask, 0, 0, 1}, .imageExtent = of.size};
    }

    void make_instance() {
        const VkApplicationInfo application{.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO,
                                            .apiVersion = VK_API_VERSION_1_1};
        const VkInstanceCreateInfo info{.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO,
                                        .pApplicationInfo = &application};
        if (vkCreateInstance(&info, nullptr, &instance_) != VK_SUCCESS)
            throw std::runtime_error("there is no Vulkan driver: install one, such as Mesa lavapipe");
        cleanup_.push_back([instance = instance_] { vkDestroyInstance(instance, nullptr); });
    }

    void choose_device(const VkPhysicalDeviceFeatures& wanted) {
        std::uint32_t count = 0;
        check(vkEnumeratePhysicalDevices(instance_, &count, nullptr), "looking for devices");
        std::vector<VkPhysicalDevice> devices(count);
        check(vkEnumeratePhysicalDevices(instance_, &count, devices.data()), "looking for devices");
        for (VkPhysicalDevice each : devices) {
            VkPhysicalDeviceFeatures has;
            vkGetPhysicalDeviceFeatures(each, &has);
            if (cover(has, wanted) && choose_queue(each)) {
                physical_ = each;
                return;
            }
        }
        throw std::runtime_error("no Vulkan device has graphics, compute and the features wanted: install "
                                 "another driver, such as Mesa lavapipe");
    }

    static bool cover(const VkPhysicalDeviceFeatures& has, const VkPhysicalDeviceFeatures& wanted) {
        using all = std::array<VkBool32, sizeof has / sizeof(VkBool32)>;
        return std::ranges::equal(std::bit_cast<all>(has), std::bit_cast<all>(wanted),
                                  std::greater_equal<>());
    }

    bool choose_queue(VkPhysicalDevice of) {
        std::uint32_t count = 0;
        vkGetPhysicalDeviceQueueFamilyProperties(of, &count, nullptr);
        std::vector<VkQueueFamilyProperties> families(count);
        vkGetPhysicalDeviceQueueFamilyProperties(of, &count, families.data());
        constexpr VkQueueFlags both = VK_QUEUE_GRAPHICS_BIT | VK_QUEUE_COMPUTE_BIT;
        for (family_ = 0; family_ < count; ++family_)
            if ((families[family_].queueFlags & both) == both)
                return true;
        return false;
    }

    void make_device(const VkPhysicalDeviceFeatures& wanted) {
        constexpr float priority = 1;
        const VkDeviceQueueCreateInfo queue{.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO,
                                            .queueFamilyIndex = family_,
                                            .queueCount = 1,
                                            .pQueuePriorities = &priority};
        const VkDeviceCreateInfo info{.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO,
                                      .queueCreateInfoCount = 1,
                                      .pQueueCreateInfos = &queue,
                                      .pEnabledFeatures = &wanted};
        check(vkCreateDevice(physical_, &info, nullptr, &device_), "creating the device");
        cleanup_.push_back([device = device_] { vkDestroyDevice(device, nullptr); });
        vkGetDeviceQueue(device_, family_, 0, &queue_);
    }

    VkDeviceMemory allocate(const VkMemoryRequirements& needs, VkMemoryPropertyFlags wanted) {
        VkPhysicalDeviceMemoryProperties memory;
        vkGetPhysicalDeviceMemoryProperties(physical_, &memory);
        for (std::uint32_t type = 0; type < memory.memoryTypeCount; ++type)
            if ((needs.memoryTypeBits >> type & 1) != 0 &&
                (memory.memoryTypes[type].propertyFlags & wanted) == wanted) {
                const VkMemoryAllocateInfo info{.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO,
                                                .allocationSize = needs.size,
                                                .memoryTypeIndex = type};
                return make<VkDeviceMemory>(vkAllocateMemory, info, vkFreeMemory);
            }
        throw std::runtime_error("the device has no memory of the kind wanted: choose another device");
    }

    VkInstance instance_{};
    VkPhysicalDevice physical_{};
    VkDevice device_{};
    VkQueue queue_{};
    std::uint32_t family_ = 0;
    std::deque<image> images_;                   // which stay where they are
    std::vector<std::function<void()>> cleanup_; // in the order of making
};
