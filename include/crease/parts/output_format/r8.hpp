// SPDX-License-Identifier: MIT
#pragma once

#include <crease/compose/part.hpp>

namespace crease {

/// Output format: visibility in one byte. The default. Storing it needs shaderStorageImageExtendedFormats.
struct r8 {
    static constexpr part description{
        .kind = role::output_format,
        .name = "r8",
        .summary = "visibility in one byte",
        .source = "",
    };
};

}
