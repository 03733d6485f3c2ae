// SPDX-License-Identifier: MIT
#pragma once

#include <vulkan/vulkan.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

// What a designated initialiser leaves out is zero, as Vulkan wants it.
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"

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

    VkDevice device() const { return device_; }

    /// Makes an object that lives as long as the renderer: make<VkSampler>(vkCreateSampler, info,
    /// vkDestroySampler).
    template <class Handle, class Create, class Info, class Destroy>
    Handle make(Create create, const Info& info, Destroy destroy) {
        Handle handle{};
        check(create(device_, &info, nullptr, &handle), "creating a Vulkan object");
        cleanup_.push_back([device = device_, destroy, handle] { destroy(device, handle, nullptr); });
        return handle;
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

    struct image {
        VkImage handle;
        VkImageView view;
        VkImageSubresourceRange range;
    };

    image make_image(VkExtent3D size, VkFormat format, VkImageUsageFlags usage, VkImageAspectFlags aspect) {
        const VkImageCreateInfo info{.sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO,
                                     .imageType = VK_IMAGE_TYPE_2D,
                                     .format = format,
                                     .extent = size,
                                     .mipLevels = 1,
                                     .arrayLayers = 1,
                                     .samples = VK_SAMPLE_COUNT_1_BIT,
                                     .usage = usage};
        image made{make<VkImage>(vkCreateImage, info, vkDestroyImage), {}, {aspect, 0, 1, 0, 1}};
        VkMemoryRequirements needs;
        vkGetImageMemoryRequirements(device_, made.handle, &needs);
        check(vkBindImageMemory(device_, made.handle, allocate(needs, 0), 0), "binding memory");
        const VkImageViewCreateInfo view{.sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO,
                                         .image = made.handle,
                                         .viewType = VK_IMAGE_VIEW_TYPE_2D,
                                         .format = format,
                                         .subresourceRange = made.range};
        made.view = make<VkImageView>(vkCreateImageView, view, vkDestroyImageView);
        return made;
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
    void make_instance() {
        const VkApplicationInfo application{.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO,
                                            .apiVersion = VK_API_VERSION_1_1};
        const VkInstanceCreateInfo info{.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO,
                                        .pApplicationInfo = &application};
        if (vkCreateInstance(&info, nullptr, &instance_) != VK_SUCCESS)
            throw std::runtime_error("there is no Vulkan driver");
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
            if (has.shaderStorageImageExtendedFormats >= wanted.shaderStorageImageExtendedFormats &&
                choose_queue(each)) {
                physical_ = each;
                return;
            }
        }
        throw std::runtime_error("no Vulkan device has graphics, compute and the features wanted");
    }

    bool choose_queue(VkPhysicalDevice of) {
        std::uint32_t count = 0;
        vkGetPhysicalDeviceQueueFamilyProperties(of, &count, nullptr);
        std::vector<VkQueueFamilyProperties> families(count);
        vkGetPhysicalDeviceQueueFamilyProperties(of, &count, families.data());
        constexpr VkQueueFlags both = VK_QUEUE_GRAPHICS_BIT | VK_QUEUE_COMPUTE_BIT; // graphics: to copy depth
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
        throw std::runtime_error("the device has no memory of the kind wanted");
    }

    VkInstance instance_{};
    VkPhysicalDevice physical_{};
    VkDevice device_{};
    VkQueue queue_{};
    std::uint32_t family_ = 0;
    std::vector<std::function<void()>> cleanup_; // in the order of making
};
