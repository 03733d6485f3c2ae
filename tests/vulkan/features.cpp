// SPDX-License-Identifier: MIT
#include <crease/vulkan/features.hpp>

#include "validated_device.hpp"

#include <doctest/doctest.h>

using namespace crease;

TEST_CASE("a feature that is not there is named") {
    CHECK(vulkan::detail::missing_features({}, {.extended_storage_formats = true}) ==
          "shaderStorageImageExtendedFormats");
    CHECK(vulkan::detail::missing_features({.extended_storage_formats = true}, {}).empty());
    CHECK(vulkan::detail::missing_features({}, {.subgroup_arithmetic = true}) ==
          "arithmetic of subgroups in compute shaders");
    CHECK(validated_device().features().subgroup_arithmetic);
    CHECK_NOTHROW(validated_device().require({}));
    CHECK_NOTHROW(validated_device().require(validated_device().features()));
}

TEST_CASE("each feature that is wanted and not there is named, and no other") {
    const device_features all{.extended_storage_formats = true,
                              .fragment_stores_and_atomics = true,
                              .subgroup_arithmetic = true,
                              .depth_samples = 4 | 8,
                              .centred_depth_samples = 4};
    const auto missing = [&](device_features there) { return vulkan::detail::missing_features(there, all); };
    CHECK(missing(all) == "");
    device_features there = all;
    there.extended_storage_formats = false;
    CHECK(missing(there) == "shaderStorageImageExtendedFormats");
    there = all;
    there.fragment_stores_and_atomics = false;
    CHECK(missing(there) == "fragmentStoresAndAtomics");
    there = all;
    there.subgroup_arithmetic = false;
    CHECK(missing(there) == "arithmetic of subgroups in compute shaders");
    there = all;
    there.depth_samples = 2 | 8;
    CHECK(missing(there) == "depth images of 4 samples a texel");
    there.depth_samples = 0;
    CHECK(missing(there) == "depth images of 4 samples a texel, depth images of 8 samples a texel");
    there = all;
    there.centred_depth_samples = 8;
    CHECK(missing(there) == "VK_EXT_sample_locations for 4 samples a texel");
}

TEST_CASE("features are those that the driver has, of all that the effect needs together") {
    VkPhysicalDeviceFeatures flags{};
    VkPhysicalDeviceLimits limits{};
    VkPhysicalDeviceSubgroupProperties subgroups{};
    CHECK(vulkan::detail::features_of(flags, limits, subgroups, ~0u) == device_features{});
    flags.shaderStorageImageExtendedFormats = VK_TRUE;
    CHECK(vulkan::detail::features_of(flags, limits, subgroups, 0) ==
          device_features{.extended_storage_formats = true});
    flags = {};
    flags.fragmentStoresAndAtomics = VK_TRUE;
    CHECK(vulkan::detail::features_of(flags, limits, subgroups, 0) ==
          device_features{.fragment_stores_and_atomics = true});
    flags = {};
    subgroups.supportedOperations = VK_SUBGROUP_FEATURE_ARITHMETIC_BIT;
    CHECK(vulkan::detail::features_of(flags, limits, subgroups, 0) == device_features{});
    subgroups.supportedStages = VK_SHADER_STAGE_COMPUTE_BIT;
    CHECK(vulkan::detail::features_of(flags, limits, subgroups, 0) ==
          device_features{.subgroup_arithmetic = true});
    subgroups = {};
    limits.framebufferDepthSampleCounts = 1 | 2 | 4;  // drawn to
    limits.sampledImageDepthSampleCounts = 1 | 4 | 8; // and read
    CHECK(vulkan::detail::features_of(flags, limits, subgroups, 8 | 4) ==
          device_features{.depth_samples = 1 | 4, .centred_depth_samples = 4});
}
