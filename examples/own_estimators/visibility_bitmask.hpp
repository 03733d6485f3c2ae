// SPDX-License-Identifier: MIT
#pragma once

#include <crease/crease.hpp>

namespace engine {

inline constexpr crease::glsl_file visibility_bitmask_glsl{
    "engine/visibility_bitmask.glsl",
#include "visibility_bitmask.glsl"
};

/// Estimator: the sectors of half slices that layers of a thickness hide. Works with every sampler of taps
/// along directions and every source of layers of depth. The defaults aim at the `hard` truth.
struct visibility_bitmask {
    using needs = crease::traits<crease::ordered_taps, crease::depth_layers>;
    static constexpr crease::setting reads[] = {
        {"thickness", 0.4f, 0, 64, "of a layer, away from the eye, in radii"},
        crease::strength_setting(1),
        crease::exponent_setting(1),
    };
    static constexpr const crease::glsl_file* files[] = {&crease::open_horizon_glsl,
                                                         &visibility_bitmask_glsl};
    static constexpr crease::part description{
        .kind = crease::role::estimator,
        .name = "visibility_bitmask",
        .summary = "the sectors of half slices that layers of a thickness hide",
        .source = "Therrien et al. 2023, Screen Space Indirect Lighting with Visibility Bitmask",
        .files = files,
        .settings = reads,
        .needs = needs::list,
        .offers = crease::traits<crease::layers_behind, crease::open_directions>::list,
    };
};

}
