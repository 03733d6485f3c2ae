// SPDX-License-Identifier: MIT
#pragma once

#include <crease/depth/layers.hpp>
#include <crease/sampler/taps.hpp>

namespace crease {

inline constexpr glsl_file unsharp_mask_glsl{
    "estimator/unsharp_mask.glsl",
#include <crease/estimator/unsharp_mask.glsl>
};

/// Estimator: the unsharp mask of the depth buffer. Depth is measured against the far plane; where there is
/// none, nothing is occluded.
struct unsharp_mask {
    using needs = traits<window_taps, depth_layers>;
    static constexpr setting reads[] = {
        {"threshold", &parameters::threshold, 0.02f, 1e-6f, 1,
         "difference of linearised depth from which a neighbour is left out; the far plane has 1"},
        {"strength", &parameters::strength, 20, 0, 1000, "factor of the difference"},
        {"exponent", &parameters::exponent, 1, 0.01f, 16, "power of the visibility"},
    };
    static constexpr part description{
        .kind = role::estimator,
        .name = "unsharp_mask",
        .summary = "depth less its mean over a window",
        .source = "unsharp-mask-ssao, (1) and listing",
        .glsl = &unsharp_mask_glsl,
        .settings = reads,
        .needs = needs::list,
        .fold = &fold_max_glsl,
    };
};

}
