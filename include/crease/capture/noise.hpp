// SPDX-License-Identifier: MIT
#pragma once

#include <crease/noise/hashed_noise.hpp>

namespace crease {

inline constexpr glsl_file fragment_noise_glsl{
    "capture/fragment_noise.glsl",
#include <crease/capture/fragment_noise.glsl>
};

inline constexpr glsl_file sine_hash_glsl{
    "capture/sine_hash.glsl",
#include <crease/capture/sine_hash.glsl>
};

inline constexpr glsl_file threshold_glsl{
    "capture/threshold.glsl",
#include <crease/capture/threshold.glsl>
};

}
