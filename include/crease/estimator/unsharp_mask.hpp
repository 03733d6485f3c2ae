// SPDX-License-Identifier: MIT
#pragma once

#include <crease/depth/areas.hpp>
#include <crease/depth/layers.hpp>
#include <crease/sampler/taps.hpp>

namespace crease {

inline constexpr glsl_file unsharp_mask_glsl{
    "estimator/unsharp_mask.glsl",
#include <crease/estimator/unsharp_mask.glsl>
};

inline constexpr glsl_file unsharp_mask_depth_glsl{
    "estimator/unsharp_mask_depth.glsl",
#include <crease/estimator/unsharp_mask_depth.glsl>
};

inline constexpr glsl_file unsharp_mask_areas_glsl{
    "estimator/unsharp_mask_areas.glsl",
#include <crease/estimator/unsharp_mask_areas.glsl>
};

/// Estimator: the unsharp mask of the depth buffer. Depth is measured against the far plane; where there is
/// none, against the AO radius. Over depth sources of areas a layer is left out as a whole, by its mean.
struct unsharp_mask {
    using needs = traits<window_taps>;
    static constexpr const glsl_file* helpers[] = {&unsharp_mask_depth_glsl};
    static constexpr extra more[] = {{&area_means::value, &unsharp_mask_depth_glsl},
                                     {&area_means::value, &unsharp_mask_areas_glsl, format::rg32_float}};
    static constexpr setting reads[] = {
        {"threshold", &parameters::threshold, 0.02f, 1e-6f, 1,
         "difference of linearised depth from which a neighbour is left out; the far plane has 1, or "
         "where there is none 50 radii do"},
        {"strength", &parameters::strength, 20, 0, 1000, "factor of the difference"},
        {"exponent", &parameters::exponent, 1, 0.01f, 16, "power of the visibility"},
    };
    static constexpr part description{
        .kind = role::estimator,
        .name = "unsharp_mask",
        .summary = "depth less its mean over a window",
        .source = "unsharp-mask-ssao, (1) and listing",
        .glsl = &unsharp_mask_glsl,
        .helpers = helpers,
        .settings = reads,
        .needs = needs::list,
        .offers = traits<area_means>::list,
        .extras = more,
        .fold = &fold_max_glsl,
    };
};

}
