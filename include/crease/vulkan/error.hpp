// SPDX-License-Identifier: MIT
#pragma once

#include <vulkan/vulkan.h>

#include <stdexcept>
#include <string>

namespace crease::vulkan {

/// What crease::vulkan throws: one sentence that says what was wanted and why it cannot be.
class error : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

}

namespace crease::vulkan::detail {

inline std::string name_of(VkResult result) {
    switch (result) {
    case VK_ERROR_OUT_OF_HOST_MEMORY:
        return "out of host memory";
    case VK_ERROR_OUT_OF_DEVICE_MEMORY:
        return "out of device memory";
    case VK_ERROR_INITIALIZATION_FAILED:
        return "initialisation failed";
    case VK_ERROR_DEVICE_LOST:
        return "the device is lost";
    case VK_ERROR_LAYER_NOT_PRESENT:
        return "a layer is not present";
    case VK_ERROR_EXTENSION_NOT_PRESENT:
        return "an extension is not present";
    case VK_ERROR_FEATURE_NOT_PRESENT:
        return "a feature is not present";
    case VK_ERROR_INCOMPATIBLE_DRIVER:
        return "there is no compatible driver";
    case VK_ERROR_FORMAT_NOT_SUPPORTED:
        return "the format is not supported";
    case VK_ERROR_VALIDATION_FAILED_EXT:
        return "validation failed";
    default:
        return "VkResult " + std::to_string(result);
    }
}

/// @param doing  what the call was for, e.g. "make a pipeline"
/// @throws error  "cannot <doing>: <reason>" where the call failed
inline void check(VkResult result, const std::string& doing) {
    if (result != VK_SUCCESS)
        throw error("cannot " + doing + ": " + name_of(result));
}

}
