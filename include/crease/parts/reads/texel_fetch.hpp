// SPDX-License-Identifier: MIT
#pragma once

#include <crease/compose/part.hpp>

namespace crease {

/// Image reads: passes read what passes write by `texelFetch` of a sampled image, which suits GPUs. The
/// default.
struct texel_fetch {
    static constexpr part description{
        .kind = role::image_reads,
        .name = "texel_fetch",
        .summary = "passes read what passes write as sampled images, texel by texel",
        .source = "",
    };
};

}
