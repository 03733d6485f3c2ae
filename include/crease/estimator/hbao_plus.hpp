// SPDX-License-Identifier: MIT
#pragma once

#include <crease/depth/layers.hpp>
#include <crease/sampler/taps.hpp>

namespace crease {

inline constexpr glsl_file hbao_plus_glsl{
    "estimator/hbao_plus.glsl",
#include <crease/estimator/hbao_plus.glsl>
};

/// Estimator: normal-projected obscurance, HBAO+. The defaults aim at the `linear` truth.
struct hbao_plus {
    using needs = traits<screen_taps, depth_layers>;
    static constexpr setting reads[] = {
        {"bias", &parameters::bias, 0.2f, 0, 1, "cosine between the normal and a tap that is taken off"},
        {"strength", &parameters::strength, 2.2f, 0, 16, "factor of the occlusion"},
        {"exponent", &parameters::exponent, 2, 0.01f, 16, "power of the visibility"},
    };
    static constexpr part description{
        .kind = role::estimator,
        .name = "hbao_plus",
        .summary = "taps projected onto the normal, with a quadratic falloff",
        .source = "stochastic-depth-ao 2020, 4.3, Algorithm 3",
        .glsl = &hbao_plus_glsl,
        .settings = reads,
        .needs = needs::list,
        .fold = &fold_max_glsl,
    };
};

}
