// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/depth/areas.hpp>
#include <crease/parts/depth/layers.hpp>
#include <crease/parts/estimator/visibility_settings.hpp>
#include <crease/parts/sampler/taps.hpp>

namespace crease {

inline constexpr glsl_file unsharp_mask_glsl{
    "estimator/unsharp_mask.glsl",
#include <crease/estimator/unsharp_mask.glsl>
};

/// Estimator: the unsharp mask of the depth buffer. Depth is measured against the far plane; where there is
/// none, against the AO radius. Over depth sources of areas a layer is left out as a whole, by its mean.
struct unsharp_mask {
    using needs = traits<window_taps>;
    static constexpr setting reads[] = {
        {"threshold", 0.02f, 1e-6f, 1,
         "difference of linearised depth from which a neighbour is left out; the far plane has 1, or "
         "where there is none 50 radii do"},
        strength_setting(20, 1000),
        exponent_setting(1),
    };
    static constexpr const glsl_file* files[] = {&unsharp_mask_glsl};
    static constexpr part description{
        .kind = role::estimator,
        .name = "unsharp_mask",
        .summary = "depth less its mean over a window",
        .source = "unsharp-mask-ssao, (1) and listing",
        .files = files,
        .settings = reads,
        .needs = needs::list,
        .offers = traits<area_means, single_area_value>::list,
    };
};

}
