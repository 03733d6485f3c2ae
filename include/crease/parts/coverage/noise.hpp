// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/noise/hashed_noise.hpp>

namespace crease {

inline constexpr glsl_file fragment_noise_glsl{
    "coverage/fragment_noise.glsl",
#include <crease/coverage/fragment_noise.glsl>
};

inline constexpr glsl_file sine_hash_glsl{
    "coverage/sine_hash.glsl",
#include <crease/coverage/sine_hash.glsl>
};

inline constexpr glsl_file threshold_glsl{
    "coverage/threshold.glsl",
#include <crease/coverage/threshold.glsl>
};

}
