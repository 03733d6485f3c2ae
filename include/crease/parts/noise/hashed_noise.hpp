// SPDX-License-Identifier: MIT
#pragma once

#include <crease/compose/part.hpp>

namespace crease {

inline constexpr glsl_file hashed_noise_glsl{
    "noise/hashed_noise.glsl",
#include <crease/noise/hashed_noise.glsl>
};

/// Noise: two random numbers per pixel and frame. The default.
struct hashed_noise {
    static constexpr const glsl_file* files[] = {&hashed_noise_glsl};
    static constexpr part description{
        .kind = role::noise,
        .name = "hashed_noise",
        .summary = "random numbers that differ from pixel to pixel and from frame to frame",
        .source = "stochastic-depth-ao 2020, Algorithms 1 to 3",
        .files = files,
    };
};

}
