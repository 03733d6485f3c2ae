// SPDX-License-Identifier: MIT
#pragma once

#include <crease/vulkan/features.hpp>
#include <crease/vulkan/host_device.hpp>
#include <crease/vulkan/sample_locations.hpp>

#include <algorithm>
#include <cstring>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace crease::vulkan {

/// Which device, and how it is watched.
struct device_options {
    std::string
        name; ///< part of the device's name; empty: the first discrete GPU, else any GPU, else software
    bool validation = false; ///< check every call by VK_LAYER_KHRONOS_validation, synchronization included
};

/// A Vulkan 1.1 device, and one queue for graphics and compute: its own, without a window, or a host's. One
/// thread at a time may use it and what was made from it, and so the host's queue. It must outlive what was
/// made from it, and a host's device must outlive it.
///
/// With validation every warning and error is collected, and the next submission of work throws them.
class device {
public:
    /// @throws error  where there is no driver, no device of that name (with those there are), or no
    /// validation layer
    explicit device(const device_options& options = {}) : instance_(std::in_place, options.validation) {
        selected_ = detail::select(*instance_, options.name);
        make_queue();
        make_commands();
        check_messages();
    }
    /// Uses a host's device as it is; its validation is the host's.
    /// @throws error  where a handle is missing, Vulkan is older than 1.1, or the queue cannot both draw and
    ///                compute
    explicit device(const host_device& of)
        : selected_(detail::select(of)), handle_(of.handle), queue_(of.queue) {
        const bool places_samples = std::ranges::any_of(of.extensions, [](const char* name) {
            return std::strcmp(name, VK_EXT_SAMPLE_LOCATIONS_EXTENSION_NAME) == 0;
        });
        find_features(of.features, places_samples);
        make_commands();
    }
    device(const device&) = delete;
    device& operator=(const device&) = delete;

    /// As the driver says it.
    std::string name() const { return selected_.properties.deviceName; }
    /// Of those that effects may require, the ones it has.
    device_features features() const { return features_; }
    /// Whether it is software that runs on a processor, such as lavapipe.
    bool is_processor() const { return selected_.properties.deviceType == VK_PHYSICAL_DEVICE_TYPE_CPU; }
    /// Vulkan's limits of the device.
    const VkPhysicalDeviceLimits& limits() const { return selected_.properties.limits; }
    /// The logical device.
    VkDevice handle() const { return handle_; }
    /// The physical device.
    VkPhysicalDevice physical() const { return selected_.physical; }

    /// @throws error  that names the features of `wanted` which the device lacks
    void require(const device_features& wanted) const {
        const std::string missing = detail::missing_features(features_, wanted);
        if (!missing.empty())
            throw error("the device '" + name() + "' " + (instance_ ? "lacks " : "was made without ") +
                        missing + ", which the effect requires");
    }

    /// @throws error  with what validation has said and no call has thrown yet
    void check_messages() {
        if (!instance_)
            return;
        std::string all;
        for (const std::string& message : instance_->take_messages())
            all += "\n" + message;
        if (!all.empty())
            throw error("Vulkan validation says:" + all);
    }

    /// Records commands, submits them and waits until they are done.
    /// @param record  called with the VkCommandBuffer
    template <class Record>
    void submit(Record record) {
        begin();
        record(command_buffer_);
        end_and_wait();
    }

    /// Milliseconds between two timestamps of the queue; NaN where it has none.
    double milliseconds(std::uint64_t from, std::uint64_t to) const {
        if (selected_.timestamp_bits == 0)
            return std::numeric_limits<double>::quiet_NaN();
        const std::uint64_t mask = ~std::uint64_t{0} >> (64 - selected_.timestamp_bits);
        return static_cast<double>((to - from) & mask) * double(selected_.properties.limits.timestampPeriod) *
               1e-6;
    }
    /// Whether its queue can measure time.
    bool has_timestamps() const { return selected_.timestamp_bits != 0; }

private:
    std::optional<detail::instance> instance_; ///< none where the device is a host's
    detail::selected_device selected_;
    device_features features_;
    detail::owned_device own_; ///< null where it is a host's
    VkDevice handle_ = VK_NULL_HANDLE;
    VkQueue queue_ = VK_NULL_HANDLE;
    detail::owned_command_pool commands_;
    VkCommandBuffer command_buffer_ = VK_NULL_HANDLE;
    detail::owned_fence fence_;

    void find_features(const VkPhysicalDeviceFeatures& enabled, bool places_samples) {
        features_ = detail::features_of(enabled, selected_.properties.limits,
                                        detail::subgroups_of(selected_.physical),
                                        places_samples ? detail::placeable_samples(selected_.physical) : 0);
    }

    void make_queue() {
        VkPhysicalDeviceFeatures supported, enabled{};
        vkGetPhysicalDeviceFeatures(selected_.physical, &supported);
        find_features(supported, true);
        for (const detail::known_feature& known : detail::known_features)
            enabled.*known.flag = supported.*known.flag;

        constexpr float priority = 1;
        auto queue = detail::blank<VkDeviceQueueCreateInfo>(VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO);
        queue.queueFamilyIndex = selected_.queue_family;
        queue.queueCount = 1;
        queue.pQueuePriorities = &priority;
        auto info = detail::blank<VkDeviceCreateInfo>(VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO);
        info.queueCreateInfoCount = 1;
        info.pQueueCreateInfos = &queue;
        info.pEnabledFeatures = &enabled;
        const char* const sample_locations = VK_EXT_SAMPLE_LOCATIONS_EXTENSION_NAME;
        info.enabledExtensionCount = features_.centred_depth_samples ? 1 : 0;
        info.ppEnabledExtensionNames = &sample_locations;
        detail::check(vkCreateDevice(selected_.physical, &info, nullptr, &own_.handle),
                      "use the device '" + name() + "'");
        handle_ = own_.handle;
        vkGetDeviceQueue(handle_, selected_.queue_family, 0, &queue_);
    }

    void make_commands() {
        auto pool = detail::blank<VkCommandPoolCreateInfo>(VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO);
        pool.queueFamilyIndex = selected_.queue_family;
        commands_ =
            detail::make<detail::owned_command_pool>(handle_, vkCreateCommandPool, pool, "a command pool");
        auto buffer =
            detail::blank<VkCommandBufferAllocateInfo>(VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO);
        buffer.commandPool = commands_;
        buffer.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
        buffer.commandBufferCount = 1;
        detail::check(vkAllocateCommandBuffers(handle_, &buffer, &command_buffer_), "make a command buffer");
        const auto fence = detail::blank<VkFenceCreateInfo>(VK_STRUCTURE_TYPE_FENCE_CREATE_INFO);
        fence_ = detail::make<detail::owned_fence>(handle_, vkCreateFence, fence, "a fence");
    }

    void begin() {
        check_messages();
        detail::check(vkResetCommandPool(handle_, commands_, 0), "reset the commands");
        auto info = detail::blank<VkCommandBufferBeginInfo>(VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO);
        info.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
        detail::check(vkBeginCommandBuffer(command_buffer_, &info), "record commands");
    }

    void end_and_wait() {
        detail::check(vkEndCommandBuffer(command_buffer_), "record commands");
        auto info = detail::blank<VkSubmitInfo>(VK_STRUCTURE_TYPE_SUBMIT_INFO);
        info.commandBufferCount = 1;
        info.pCommandBuffers = &command_buffer_;
        const VkFence fence = fence_;
        detail::check(vkQueueSubmit(queue_, 1, &info, fence), "submit commands");
        detail::check(vkWaitForFences(handle_, 1, &fence, VK_TRUE, ~std::uint64_t{0}), "wait for the device");
        detail::check(vkResetFences(handle_, 1, &fence), "reset a fence");
        check_messages();
    }
};

/// The names of all Vulkan devices on this machine.
/// @throws error  where there is no driver
inline std::vector<std::string> device_names() {
    const detail::instance here(false);
    std::vector<std::string> names;
    for (VkPhysicalDevice physical : here.devices())
        names.emplace_back(detail::properties_of(physical).deviceName);
    return names;
}

}
