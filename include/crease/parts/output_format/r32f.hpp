// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/output_format/formats.hpp>

namespace crease {

/// Output format: visibility as a 32-bit number, not rounded.
struct r32f {
    static constexpr part description{
        .kind = role::output_format,
        .name = "r32f",
        .summary = "visibility as a 32-bit number, which every device can store",
        .source = "",
        .offers = traits<real_number>::list,
    };
};

}
