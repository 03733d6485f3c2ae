// SPDX-License-Identifier: MIT
#pragma once

#include <crease/part.hpp>

namespace crease {

/// What outputs share that need no more of the taps than the occlusion.
inline constexpr glsl_file occlusion_alone_glsl{
    "output/occlusion_alone.glsl",
#include <crease/output/occlusion_alone.glsl>
};

}
