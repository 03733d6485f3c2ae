// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/coverage/noise.hpp>
#include <crease/parts/coverage/opacity.hpp>

namespace crease {

inline constexpr glsl_file simple_hash_glsl{
    "coverage/simple_hash.glsl",
#include <crease/coverage/simple_hash.glsl>
};

/// Coverage: a coin for each sample.
struct simple_hash {
    static constexpr const glsl_file* files[] = {&hashed_noise_glsl, &fragment_noise_glsl, &simple_hash_glsl};
    static constexpr part description{
        .kind = role::coverage,
        .name = "simple_hash",
        .summary = "a coin for each sample",
        .source = "stochastic-depth-ao 2020, 5.1, Algorithm 4",
        .files = files,
        .settings = opacity_setting,
    };
};

}
