// SPDX-License-Identifier: MIT
#pragma once

#include <crease/depth/layers.hpp>
#include <crease/sampler/taps.hpp>

namespace crease {

inline constexpr glsl_file ssao_glsl{
    "estimator/ssao.glsl",
#include <crease/estimator/ssao.glsl>
};

/// Estimator: screen-space ambient occlusion by range-checked points. The defaults aim at the `linear` truth.
struct ssao {
    using needs = traits<point_taps, depth_layers>;
    static constexpr setting reads[] = {
        {"bias", &parameters::bias, 0.01f, 0, 1,
         "height over the tangent plane, in radii, below which a point is left out"},
        {"strength", &parameters::strength, 0.6f, 0, 16, "factor of the occlusion"},
        {"exponent", &parameters::exponent, 2, 0.01f, 16, "power of the visibility"},
    };
    static constexpr part description{
        .kind = role::estimator,
        .name = "ssao",
        .summary = "the share of points in the hemisphere that are behind a surface near enough",
        .source = "stochastic-depth-ao 2020, 4.1, Algorithm 1",
        .glsl = &ssao_glsl,
        .settings = reads,
        .needs = needs::list,
        .fold = &fold_max_glsl,
    };
};

}
