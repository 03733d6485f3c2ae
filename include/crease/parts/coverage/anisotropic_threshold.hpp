// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/coverage/noise.hpp>
#include <crease/parts/coverage/opacity.hpp>

namespace crease {

inline constexpr glsl_file anisotropic_threshold_glsl{
    "coverage/anisotropic_threshold.glsl",
#include <crease/coverage/anisotropic_threshold.glsl>
};

/// Coverage: thresholds anchored to the surface, by the footprint along each axis.
struct anisotropic_threshold {
    static constexpr const glsl_file* files[] = {&sine_hash_glsl, &threshold_glsl,
                                                 &anisotropic_threshold_glsl};
    static constexpr part description{
        .kind = role::coverage,
        .name = "anisotropic_threshold",
        .summary = "thresholds that stay on the surface, as fine as a texel at grazing angles too",
        .source = "stochastic-depth-ao 2020, 8.2",
        .files = files,
        .settings = opacity_setting,
    };
};

}
