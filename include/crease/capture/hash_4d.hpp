// SPDX-License-Identifier: MIT
#pragma once

#include <crease/capture/noise.hpp>

namespace crease {

inline constexpr glsl_file hash_4d_glsl{
    "capture/hash_4d.glsl",
#include <crease/capture/hash_4d.glsl>
};

/// Layer sampling: a coin for each sample, by nested hashes.
struct hash_4d {
    static constexpr const glsl_file* helpers[] = {&sine_hash_glsl};
    static constexpr part description{
        .kind = role::layer_sampling,
        .name = "hash_4d",
        .summary = "a coin for each sample, by nested hashes of the place on the screen",
        .source = "stochastic-depth-ao 2020, 8.2",
        .glsl = &hash_4d_glsl,
        .helpers = helpers,
    };
};

}
