// SPDX-License-Identifier: MIT
#pragma once

#include <crease/capture/noise.hpp>

namespace crease {

inline constexpr glsl_file anisotropic_threshold_glsl{
    "capture/anisotropic_threshold.glsl",
#include <crease/capture/anisotropic_threshold.glsl>
};

/// Layer sampling: thresholds anchored to the surface, by the footprint along each axis.
struct anisotropic_threshold {
    static constexpr const glsl_file* helpers[] = {&sine_hash_glsl, &threshold_glsl};
    static constexpr part description{
        .kind = role::layer_sampling,
        .name = "anisotropic_threshold",
        .summary = "thresholds that stay on the surface, as fine as a texel at grazing angles too",
        .source = "stochastic-depth-ao 2020, 8.2",
        .glsl = &anisotropic_threshold_glsl,
        .helpers = helpers,
    };
};

}
