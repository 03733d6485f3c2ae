// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace crease::spirv {

/// The Vulkan version that a module is made for, and whose rules it is held to. It says the version of
/// SPIR-V: 1.0, 1.3, 1.5 and 1.6.
enum class vulkan_version : unsigned char { v1_0, v1_1, v1_2, v1_3 };

/// As in "1.1".
constexpr std::string_view name_of(vulkan_version version) {
    constexpr std::string_view names[] = {"1.0", "1.1", "1.2", "1.3"};
    return names[static_cast<unsigned>(version)];
}

}
