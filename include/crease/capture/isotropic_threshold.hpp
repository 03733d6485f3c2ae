// SPDX-License-Identifier: MIT
#pragma once

#include <crease/capture/noise.hpp>

namespace crease {

inline constexpr glsl_file isotropic_threshold_glsl{
    "capture/isotropic_threshold.glsl",
#include <crease/capture/isotropic_threshold.glsl>
};

/// Layer sampling: thresholds anchored to the surface.
struct isotropic_threshold {
    static constexpr const glsl_file* helpers[] = {&sine_hash_glsl, &threshold_glsl};
    static constexpr part description{
        .kind = role::layer_sampling,
        .name = "isotropic_threshold",
        .summary = "thresholds that stay on the surface when the camera moves",
        .source = "stochastic-depth-ao 2020, 8.2",
        .glsl = &isotropic_threshold_glsl,
        .helpers = helpers,
    };
};

}
