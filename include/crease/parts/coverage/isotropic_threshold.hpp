// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/coverage/noise.hpp>
#include <crease/parts/coverage/opacity.hpp>

namespace crease {

inline constexpr glsl_file isotropic_threshold_glsl{
    "coverage/isotropic_threshold.glsl",
#include <crease/coverage/isotropic_threshold.glsl>
};

/// Coverage: thresholds anchored to the surface.
struct isotropic_threshold {
    static constexpr const glsl_file* files[] = {&sine_hash_glsl, &threshold_glsl, &isotropic_threshold_glsl};
    static constexpr part description{
        .kind = role::coverage,
        .name = "isotropic_threshold",
        .summary = "thresholds that stay on the surface when the camera moves",
        .source = "stochastic-depth-ao 2020, 8.2",
        .files = files,
        .settings = opacity_setting,
    };
};

}
