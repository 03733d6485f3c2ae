// SPDX-License-Identifier: MIT
#pragma once

namespace crease {

/// Device features that an effect requires beyond Vulkan 1.1 or OpenGL 4.3.
struct device_features {
    /// Vulkan: shaderStorageImageExtendedFormats (storing to R8, RG32). Core in OpenGL 4.3.
    bool extended_storage_formats = false;
    /// Vulkan: fragmentStoresAndAtomics. Core in OpenGL 4.3.
    bool fragment_stores_and_atomics = false;
    /// Subgroup arithmetic in compute shaders: VK_SUBGROUP_FEATURE_ARITHMETIC_BIT.
    bool subgroup_arithmetic = false;
    /// Sample counts of depth images that are drawn to and sampled, or-ed together, as in 4 | 8; 0: none.
    unsigned depth_samples = 0;
    /// The same of depth images whose samples all lie at the centre of the texel: VK_EXT_sample_locations.
    unsigned centred_depth_samples = 0;

    /// Whether a device that has these features can run what requires `wanted`.
    constexpr bool cover(const device_features& wanted) const {
        return (extended_storage_formats || !wanted.extended_storage_formats) &&
               (fragment_stores_and_atomics || !wanted.fragment_stores_and_atomics) &&
               (subgroup_arithmetic || !wanted.subgroup_arithmetic) &&
               (depth_samples & wanted.depth_samples) == wanted.depth_samples &&
               (centred_depth_samples & wanted.centred_depth_samples) == wanted.centred_depth_samples;
    }
    /// Adds what another effect, pass or part requires.
    constexpr device_features& operator|=(const device_features& more) {
        extended_storage_formats |= more.extended_storage_formats;
        fragment_stores_and_atomics |= more.fragment_stores_and_atomics;
        subgroup_arithmetic |= more.subgroup_arithmetic;
        depth_samples |= more.depth_samples;
        centred_depth_samples |= more.centred_depth_samples;
        return *this;
    }
    /// Member by member.
    constexpr bool operator==(const device_features&) const = default;
};

}
