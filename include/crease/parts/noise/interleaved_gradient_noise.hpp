// SPDX-License-Identifier: MIT
#pragma once

#include <crease/compose/part.hpp>

namespace crease {

inline constexpr glsl_file interleaved_gradient_noise_glsl{
    "noise/interleaved_gradient_noise.glsl",
#include <crease/noise/interleaved_gradient_noise.glsl>
};

/// Noise: interleaved gradient noise, which a blur over a few pixels evens out best; on faint gradients it
/// leaves a diagonal weave, which one over 7 x 7 pixels does not.
struct interleaved_gradient_noise {
    static constexpr const glsl_file* files[] = {&interleaved_gradient_noise_glsl};
    static constexpr part description{
        .kind = role::noise,
        .name = "interleaved_gradient_noise",
        .summary = "numbers of which any 3 x 3 pixels have nearly all, for filters of a few pixels",
        .source = "Jimenez 2014, Next Generation Post Processing in Call of Duty: Advanced Warfare",
        .files = files,
    };
};

}
