// SPDX-License-Identifier: MIT
#pragma once

#include <crease/compose/part.hpp>

namespace crease {

/// Dialect: GLSL 450 for Vulkan 1.1 and up. The default.
struct vulkan_glsl {
    static constexpr part description{
        .kind = role::dialect,
        .name = "vulkan",
        .summary = "GLSL 450 for Vulkan 1.1 and up",
        .source = "",
    };
};

}
