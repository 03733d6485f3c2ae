// SPDX-License-Identifier: MIT
#pragma once

#include <crease/crease.hpp>

namespace engine {

inline constexpr crease::glsl_file gtao_glsl{
    "engine/gtao.glsl", // what a compiler's message will name
#include "gtao.glsl"
};

/// Estimator: ground-truth ambient occlusion by the horizons of half slices. Works with every sampler of taps
/// along directions and every source of layers of depth.
struct gtao {
    using needs = crease::traits<crease::ordered_taps, crease::depth_layers>;
    static constexpr crease::setting reads[] = {
        {"falloff", 0.615f, 0, 1,
         "outer share of the radius over which a horizon falls to the tangent plane"},
        crease::strength_setting(1),
        crease::exponent_setting(1),
    };
    static constexpr const crease::glsl_file* files[] = {&crease::open_horizon_glsl, &gtao_glsl};
    static constexpr crease::part description{
        .kind = crease::role::estimator,
        .name = "gtao",
        .summary = "the cosine-weighted integral over the horizons of half slices",
        .source = "Jimenez et al. 2016, Practical Realtime Strategies for Accurate Indirect Occlusion",
        .files = files,
        .settings = reads,
        .needs = needs::list,
        .offers = crease::traits<crease::layers_behind, crease::open_directions>::list,
    };
};

}
