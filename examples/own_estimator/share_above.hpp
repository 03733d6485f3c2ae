// SPDX-License-Identifier: MIT
#pragma once

#include <crease/crease.hpp>

namespace engine {

inline constexpr crease::glsl_file share_above_glsl{
    "engine/share_above.glsl", // what a compiler's message will name
#include "share_above.glsl"
};

/// Estimator of the engine: works with every sampler that taps the screen and every source with layers of
/// depth.
struct share_above {
    using needs = crease::traits<crease::screen_taps, crease::depth_layers>;
    static constexpr crease::setting reads[] = {
        {"bias", &crease::parameters::bias, 0.05f, 0, 1, "height over the tangent plane, in radii"},
        {"strength", &crease::parameters::strength, 1, 0, 16, "factor of the occlusion"},
    };
    static constexpr crease::part description{
        .kind = crease::role::estimator,
        .name = "share_above",
        .summary = "the share of taps over the tangent plane, with a linear falloff",
        .source = "the engine",
        .glsl = &share_above_glsl,
        .settings = reads,
        .needs = needs::list,
        .fold = &crease::fold_max_glsl,
    };
};

}
