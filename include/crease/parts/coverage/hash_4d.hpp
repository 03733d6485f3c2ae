// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/coverage/noise.hpp>
#include <crease/parts/coverage/opacity.hpp>

namespace crease {

inline constexpr glsl_file hash_4d_glsl{
    "coverage/hash_4d.glsl",
#include <crease/coverage/hash_4d.glsl>
};

/// Coverage: a coin for each sample, by nested hashes.
struct hash_4d {
    static constexpr const glsl_file* files[] = {&sine_hash_glsl, &hash_4d_glsl};
    static constexpr part description{
        .kind = role::coverage,
        .name = "hash_4d",
        .summary = "a coin for each sample, by nested hashes of the place on the screen",
        .source = "stochastic-depth-ao 2020, 8.2",
        .files = files,
        .settings = opacity_setting,
    };
};

}
