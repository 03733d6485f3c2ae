// SPDX-License-Identifier: MIT
#pragma once

#include <crease/effect/effect_view.hpp>

#include <vulkan/vulkan.h>

#include <string>

namespace crease::vulkan::detail {

/// A feature as crease and as Vulkan name it.
struct known_feature {
    bool device_features::*field;
    VkBool32 VkPhysicalDeviceFeatures::*flag;
    const char* name;
};

/// All that Vulkan has as a flag: a new one in crease::device_features needs one line here.
inline constexpr known_feature known_features[] = {
    {&device_features::extended_storage_formats, &VkPhysicalDeviceFeatures::shaderStorageImageExtendedFormats,
     "shaderStorageImageExtendedFormats"},
    {&device_features::fragment_stores_and_atomics, &VkPhysicalDeviceFeatures::fragmentStoresAndAtomics,
     "fragmentStoresAndAtomics"},
};

constexpr device_features features_of(const VkPhysicalDeviceFeatures& supported,
                                      const VkPhysicalDeviceLimits& limits,
                                      const VkPhysicalDeviceSubgroupProperties& subgroups,
                                      VkSampleCountFlags placeable) {
    device_features features;
    features.subgroup_arithmetic = (subgroups.supportedOperations & VK_SUBGROUP_FEATURE_ARITHMETIC_BIT) &&
                                   (subgroups.supportedStages & VK_SHADER_STAGE_COMPUTE_BIT);
    features.depth_samples = limits.framebufferDepthSampleCounts & limits.sampledImageDepthSampleCounts;
    features.centred_depth_samples = features.depth_samples & placeable;
    for (const known_feature& known : known_features)
        features.*known.field = supported.*known.flag;
    return features;
}

/// What is wanted and not there, by Vulkan's names, separated by ", "; empty where all is there.
inline std::string missing_features(const device_features& there, const device_features& wanted) {
    std::string missing;
    const auto add = [&](const std::string& name) {
        missing.append(missing.empty() ? "" : ", ").append(name);
    };
    const auto add_counts = [&](unsigned counts, const std::string& name) {
        for (unsigned samples = 1; samples <= counts; samples *= 2)
            if (counts & samples)
                add(name + " " + std::to_string(samples) + " samples a texel");
    };
    for (const known_feature& known : known_features)
        if (wanted.*known.field && !(there.*known.field))
            add(known.name);
    if (wanted.subgroup_arithmetic && !there.subgroup_arithmetic)
        add("arithmetic of subgroups in compute shaders");
    add_counts(wanted.depth_samples & ~there.depth_samples, "depth images of");
    add_counts(wanted.centred_depth_samples & ~there.centred_depth_samples, "VK_EXT_sample_locations for");
    return missing;
}

}
