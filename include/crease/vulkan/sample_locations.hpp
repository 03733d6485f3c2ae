// SPDX-License-Identifier: MIT
#pragma once

#include <crease/vulkan/owned.hpp>

#include <algorithm>
#include <cstring>
#include <vector>

namespace crease::vulkan::detail {

/// All samples of a texel at its centre, as VK_EXT_sample_locations takes that. Views static storage.
/// @param samples  a power of 2, at most 32
inline VkSampleLocationsInfoEXT at_the_centre(std::uint32_t samples) {
    static const std::vector<VkSampleLocationEXT> centres(32, {0.5f, 0.5f});
    auto info = blank<VkSampleLocationsInfoEXT>(VK_STRUCTURE_TYPE_SAMPLE_LOCATIONS_INFO_EXT);
    info.sampleLocationsPerPixel = static_cast<VkSampleCountFlagBits>(samples);
    info.sampleLocationGridSize = {1, 1};
    info.sampleLocationsCount = samples;
    info.pSampleLocations = centres.data();
    return info;
}

/// Sums of the sample counts that a device can place at the centre; 0 where it has no
/// VK_EXT_sample_locations.
/// @param physical  of Vulkan 1.1
inline VkSampleCountFlags placeable_samples(VkPhysicalDevice physical) {
    std::uint32_t count = 0;
    vkEnumerateDeviceExtensionProperties(physical, nullptr, &count, nullptr);
    std::vector<VkExtensionProperties> extensions(count);
    vkEnumerateDeviceExtensionProperties(physical, nullptr, &count, extensions.data());
    const bool there = std::ranges::any_of(extensions, [](const VkExtensionProperties& each) {
        return std::strcmp(each.extensionName, VK_EXT_SAMPLE_LOCATIONS_EXTENSION_NAME) == 0;
    });
    auto locations = blank<VkPhysicalDeviceSampleLocationsPropertiesEXT>(
        VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_SAMPLE_LOCATIONS_PROPERTIES_EXT);
    auto all = blank<VkPhysicalDeviceProperties2>(VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2);
    all.pNext = &locations;
    if (there)
        vkGetPhysicalDeviceProperties2(physical, &all);
    return locations.sampleLocationSampleCounts;
}

}
