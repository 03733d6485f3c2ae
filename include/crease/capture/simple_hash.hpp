// SPDX-License-Identifier: MIT
#pragma once

#include <crease/capture/noise.hpp>

namespace crease {

inline constexpr glsl_file simple_hash_glsl{
    "capture/simple_hash.glsl",
#include <crease/capture/simple_hash.glsl>
};

/// Layer sampling: a coin for each sample.
struct simple_hash {
    static constexpr const glsl_file* helpers[] = {&hashed_noise_glsl, &fragment_noise_glsl};
    static constexpr part description{
        .kind = role::layer_sampling,
        .name = "simple_hash",
        .summary = "a coin for each sample",
        .source = "stochastic-depth-ao 2020, 5.1, Algorithm 4",
        .glsl = &simple_hash_glsl,
        .helpers = helpers,
    };
};

}
