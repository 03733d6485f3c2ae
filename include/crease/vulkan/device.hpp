// SPDX-License-Identifier: MIT
#pragma once

#include <crease/vulkan/features.hpp>
#include <crease/vulkan/instance.hpp>

#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace crease::vulkan {

struct device_options {
    std::string name;        ///< part of the device's name; empty: the first discrete GPU, else any GPU, else software
    bool validation = false; ///< check every call by VK_LAYER_KHRONOS_validation, synchronization included
};

/// A Vulkan 1.1 device without a window, and one queue for graphics and compute. One thread at a time may use it and
/// what was made from it. It must outlive what was made from it.
///
/// With validation every warning and error is collected, and the next submission of work throws them.
class device {
public:
    /// @throws error  where there is no driver, no device of that name (with those there are), or no validation layer
    explicit device(const device_options& options = {}) : instance_(options.validation) {
        choose(options.name);
        make_queue();
        make_commands();
        check_messages();
    }
    ~device() {
        fence_ = {};
        commands_ = {};
        if (handle_)
            vkDestroyDevice(handle_, nullptr);
    }
    device(const device&) = delete;
    device& operator=(const device&) = delete;

    std::string name() const { return properties_.deviceName; }
    device_features features() const { return features_; }
    const VkPhysicalDeviceLimits& limits() const { return properties_.limits; }
    VkDevice handle() const { return handle_; }
    VkPhysicalDevice physical() const { return physical_; }

    /// @throws error  that names the features of `wanted` which the device lacks
    void require(const device_features& wanted) const {
        const std::string missing = detail::missing_features(features_, wanted);
        if (!missing.empty())
            throw error("the device '" + name() + "' lacks " + missing + ", which the effect requires");
    }

    /// @throws error  with what validation has said and no call has thrown yet
    void check_messages() {
        std::string all;
        for (const std::string& message : instance_.take_messages())
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
        if (timestamp_bits_ == 0)
            return std::numeric_limits<double>::quiet_NaN();
        const std::uint64_t mask = ~std::uint64_t{0} >> (64 - timestamp_bits_);
        return static_cast<double>((to - from) & mask) * double(properties_.limits.timestampPeriod) * 1e-6;
    }
    bool has_timestamps() const { return timestamp_bits_ != 0; }

private:
    detail::instance instance_;
    VkPhysicalDevice physical_ = VK_NULL_HANDLE;
    VkPhysicalDeviceProperties properties_{};
    device_features features_;
    std::uint32_t queue_family_ = 0, timestamp_bits_ = 0;
    VkDevice handle_ = VK_NULL_HANDLE;
    VkQueue queue_ = VK_NULL_HANDLE;
    detail::owned_command_pool commands_;
    VkCommandBuffer command_buffer_ = VK_NULL_HANDLE;
    detail::owned_fence fence_;

    static VkPhysicalDeviceProperties properties_of(VkPhysicalDevice physical) {
        VkPhysicalDeviceProperties properties;
        vkGetPhysicalDeviceProperties(physical, &properties);
        return properties;
    }

    static std::vector<VkQueueFamilyProperties> families_of(VkPhysicalDevice physical) {
        std::uint32_t count = 0;
        vkGetPhysicalDeviceQueueFamilyProperties(physical, &count, nullptr);
        std::vector<VkQueueFamilyProperties> families(count);
        vkGetPhysicalDeviceQueueFamilyProperties(physical, &count, families.data());
        return families;
    }

    static std::optional<std::uint32_t> family_for_all(const std::vector<VkQueueFamilyProperties>& families) {
        constexpr VkQueueFlags wanted = VK_QUEUE_GRAPHICS_BIT | VK_QUEUE_COMPUTE_BIT;
        for (std::uint32_t i = 0; i < families.size(); ++i)
            if ((families[i].queueFlags & wanted) == wanted)
                return i;
        return std::nullopt;
    }

    /// 0 is the best.
    static int rank_of(VkPhysicalDeviceType type) {
        switch (type) {
        case VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU:
            return 0;
        case VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU:
        case VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU:
            return 1;
        default:
            return 2;
        }
    }

    void choose(const std::string& wanted) {
        std::string there;
        int best = 3;
        for (VkPhysicalDevice physical : instance_.devices()) {
            const VkPhysicalDeviceProperties properties = properties_of(physical);
            const auto family = family_for_all(families_of(physical));
            if (properties.apiVersion < VK_API_VERSION_1_1 || !family)
                continue;
            const std::string its_name = properties.deviceName;
            there += (there.empty() ? "'" : ", '") + its_name + "'";
            const int rank = rank_of(properties.deviceType);
            if (its_name.find(wanted) == std::string::npos || rank >= best)
                continue;
            best = rank;
            physical_ = physical;
            properties_ = properties;
            queue_family_ = *family;
        }
        if (there.empty())
            throw error("there is no Vulkan 1.1 device with a queue for graphics and compute on this machine");
        if (!physical_)
            throw error("there is no Vulkan device named '" + wanted + "'; there is " + there);
        timestamp_bits_ = families_of(physical_)[queue_family_].timestampValidBits;
    }

    void make_queue() {
        VkPhysicalDeviceFeatures supported, enabled{};
        vkGetPhysicalDeviceFeatures(physical_, &supported);
        features_ = detail::features_of(supported);
        for (const detail::known_feature& known : detail::known_features)
            enabled.*known.flag = supported.*known.flag;
        enabled.fragmentStoresAndAtomics = supported.fragmentStoresAndAtomics;

        constexpr float priority = 1;
        auto queue = detail::blank<VkDeviceQueueCreateInfo>(VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO);
        queue.queueFamilyIndex = queue_family_;
        queue.queueCount = 1;
        queue.pQueuePriorities = &priority;
        auto info = detail::blank<VkDeviceCreateInfo>(VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO);
        info.queueCreateInfoCount = 1;
        info.pQueueCreateInfos = &queue;
        info.pEnabledFeatures = &enabled;
        detail::check(vkCreateDevice(physical_, &info, nullptr, &handle_), "use the device '" + name() + "'");
        vkGetDeviceQueue(handle_, queue_family_, 0, &queue_);
    }

    void make_commands() {
        auto pool = detail::blank<VkCommandPoolCreateInfo>(VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO);
        pool.queueFamilyIndex = queue_family_;
        commands_ = detail::make<detail::owned_command_pool>(handle_, vkCreateCommandPool, pool, "a command pool");
        auto buffer = detail::blank<VkCommandBufferAllocateInfo>(VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO);
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
    for (VkPhysicalDevice physical : here.devices()) {
        VkPhysicalDeviceProperties properties;
        vkGetPhysicalDeviceProperties(physical, &properties);
        names.emplace_back(properties.deviceName);
    }
    return names;
}

}
