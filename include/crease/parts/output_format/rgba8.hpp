// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/output_format/formats.hpp>

namespace crease {

/// Output format: visibility in each of four bytes, for devices that store no single byte.
struct rgba8 {
    static constexpr part description{
        .kind = role::output_format,
        .name = "rgba8",
        .summary = "visibility in each byte of four, which every device can store",
        .source = "",
        .offers = traits<four_bytes>::list,
    };
};

}
