// SPDX-License-Identifier: MIT
#pragma once

#include <crease/compose/part.hpp>

namespace crease {

/// Reads storage images.
CREASE_TRAIT(image_loads, image_reads, "passes must load what passes write, and they fetch it");

/// Image reads: passes read what passes write by `imageLoad` of a storage image, which is faster with drivers
/// that run on a processor.
struct image_load {
    static constexpr part description{
        .kind = role::image_reads,
        .name = "image_load",
        .summary = "passes read what passes write as storage images",
        .source = "",
        .offers = traits<image_loads>::list,
    };
};

}
