// SPDX-License-Identifier: MIT
#pragma once

#include <crease/part.hpp>

namespace crease {

/// What outputs share that need no more of the taps than the occlusion.
inline constexpr glsl_file occlusion_alone_glsl{
    "output/occlusion_alone.glsl",
#include <crease/output/occlusion_alone.glsl>
};

/// Takes nothing of single taps.
CREASE_TRAIT(any_order, output,
             "the fold comes back to a tap after others, and the output takes taps in order");

}
