// SPDX-License-Identifier: MIT
#pragma once

#include <crease/vulkan/device.hpp>

/// One device with validation for all tests: any misuse of Vulkan fails the test that follows it.
inline crease::vulkan::device& validated_device() {
    static crease::vulkan::device device({.name = {}, .validation = true});
    return device;
}
