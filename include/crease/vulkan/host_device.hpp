// SPDX-License-Identifier: MIT
#pragma once

#include <crease/vulkan/selection.hpp>

#include <span>
#include <string>

namespace crease::vulkan {

/// A device of a host's own, which crease uses and does not destroy. What it was made with Vulkan does not
/// tell, so the host says it.
struct host_device {
    VkPhysicalDevice physical = VK_NULL_HANDLE;     ///< the physical device
    VkDevice handle = VK_NULL_HANDLE;               ///< the logical device
    VkQueue queue = VK_NULL_HANDLE;                 ///< that crease submits to
    std::uint32_t queue_family = 0;                 ///< of the queue; with graphics and compute
    std::uint32_t api_version = VK_API_VERSION_1_0; ///< of its instance, as VkApplicationInfo says
    VkPhysicalDeviceFeatures features{};            ///< that were enabled
    std::span<const char* const> extensions{};      ///< of the device, that were enabled
};

}

namespace crease::vulkan::detail {

/// @throws error  where a handle is missing, Vulkan is older than 1.1, or the queue's family has not both
///                graphics and compute
inline selected_device select(const host_device& of) {
    if (!of.physical || !of.handle || !of.queue)
        throw error(std::string("a host's device has a VkPhysicalDevice, a VkDevice and a VkQueue; the ") +
                    (!of.physical ? "first"
                     : !of.handle ? "second"
                                  : "third") +
                    " is null");
    selected_device device{of.physical, properties_of(of.physical), of.queue_family};
    const std::string name = device.properties.deviceName;
    const std::uint32_t version = std::min(of.api_version, device.properties.apiVersion);
    if (version < VK_API_VERSION_1_1)
        throw error("the instance of the device '" + name + "' is of Vulkan " +
                    std::to_string(VK_API_VERSION_MAJOR(version)) + "." +
                    std::to_string(VK_API_VERSION_MINOR(version)) +
                    "; crease needs 1.1, in VkApplicationInfo and in host_device::api_version");
    const std::vector<VkQueueFamilyProperties> families = queue_families_of(of.physical);
    if (of.queue_family >= families.size())
        throw error("the device '" + name + "' has no queue family " + std::to_string(of.queue_family) +
                    "; it has " + std::to_string(families.size()));
    if (!draws_and_computes(families[of.queue_family]))
        throw error("the queue family " + std::to_string(of.queue_family) + " of the device '" + name +
                    "' has not both graphics and compute");
    device.timestamp_bits = families[of.queue_family].timestampValidBits;
    return device;
}

}
