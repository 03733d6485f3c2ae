// SPDX-License-Identifier: MIT
#pragma once

#include <crease/crease.hpp>

namespace engine {

inline constexpr crease::glsl_file openness_glsl{
    "engine/openness.glsl", // what a compiler's message will name
#include "openness.glsl"
};

/// Estimator: how high the surroundings rise, as maps of terrain show it. Works with every sampler of taps
/// along directions and every source of layers of depth.
struct openness {
    using needs = crease::traits<crease::ordered_taps, crease::depth_layers>;
    static constexpr crease::setting reads[] = {
        {"reach", 0.5f, 0, 1, "up to which distance all count wholly, radii"},
        {"bias", 0.05f, 0, 1, "taken off the sine of an angle over the tangent plane"},
        crease::strength_setting(1),
        crease::exponent_setting(1),
    };
    static constexpr const crease::glsl_file* files[] = {&crease::open_horizon_glsl, &openness_glsl};
    static constexpr crease::part description{
        .kind = crease::role::estimator,
        .name = "openness",
        .summary = "the mean angle that is open over the tangent plane",
        .source = "Yokoyama et al. 2002, Visualizing Topography by Openness",
        .files = files,
        .settings = reads,
        .needs = needs::list,
        .offers = crease::traits<crease::layers_behind, crease::open_directions>::list,
    };
};

}
