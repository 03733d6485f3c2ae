// SPDX-License-Identifier: MIT
#pragma once

#include <crease/vulkan/instance.hpp>

#include <optional>
#include <string>
#include <vector>

namespace crease::vulkan::detail {

/// A physical device, and its queue family for graphics and compute.
struct selected_device {
    VkPhysicalDevice physical = VK_NULL_HANDLE;
    VkPhysicalDeviceProperties properties{};
    std::uint32_t queue_family = 0;
    std::uint32_t timestamp_bits = 0; ///< 0: its queue has no timestamps
};

inline VkPhysicalDeviceProperties properties_of(VkPhysicalDevice physical) {
    VkPhysicalDeviceProperties properties;
    vkGetPhysicalDeviceProperties(physical, &properties);
    return properties;
}

/// @param physical  of Vulkan 1.1
inline VkPhysicalDeviceSubgroupProperties subgroups_of(VkPhysicalDevice physical) {
    auto subgroups =
        blank<VkPhysicalDeviceSubgroupProperties>(VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_SUBGROUP_PROPERTIES);
    auto all = blank<VkPhysicalDeviceProperties2>(VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2);
    all.pNext = &subgroups;
    vkGetPhysicalDeviceProperties2(physical, &all);
    return subgroups;
}

inline std::vector<VkQueueFamilyProperties> queue_families_of(VkPhysicalDevice physical) {
    std::uint32_t count = 0;
    vkGetPhysicalDeviceQueueFamilyProperties(physical, &count, nullptr);
    std::vector<VkQueueFamilyProperties> families(count);
    vkGetPhysicalDeviceQueueFamilyProperties(physical, &count, families.data());
    return families;
}

constexpr bool draws_and_computes(const VkQueueFamilyProperties& family) {
    constexpr VkQueueFlags both = VK_QUEUE_GRAPHICS_BIT | VK_QUEUE_COMPUTE_BIT;
    return (family.queueFlags & both) == both;
}

/// @return nothing where the device is older than Vulkan 1.1 or has no queue for graphics and compute
inline std::optional<selected_device> usable(VkPhysicalDevice physical) {
    selected_device device{physical, properties_of(physical)};
    if (device.properties.apiVersion < VK_API_VERSION_1_1)
        return std::nullopt;
    for (const VkQueueFamilyProperties& family : queue_families_of(physical)) {
        device.timestamp_bits = family.timestampValidBits;
        if (draws_and_computes(family))
            return device;
        ++device.queue_family;
    }
    return std::nullopt;
}

/// 0 is the best.
constexpr int rank_of(VkPhysicalDeviceType type) {
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

/// The best device whose name contains `wanted`.
/// @throws error  where there is none, with the names there are
inline selected_device select(const instance& from, const std::string& wanted) {
    std::optional<selected_device> best;
    std::string names;
    for (VkPhysicalDevice physical : from.devices()) {
        const std::optional<selected_device> device = usable(physical);
        if (!device)
            continue;
        const std::string name = device->properties.deviceName;
        names += (names.empty() ? "'" : ", '") + name + "'";
        const bool better =
            !best || rank_of(device->properties.deviceType) < rank_of(best->properties.deviceType);
        if (name.find(wanted) != std::string::npos && better)
            best = device;
    }
    if (names.empty())
        throw error("there is no Vulkan 1.1 device with a queue for graphics and compute on this machine");
    if (!best)
        throw error("there is no Vulkan device named '" + wanted + "'; there is " + names);
    return *best;
}

}
