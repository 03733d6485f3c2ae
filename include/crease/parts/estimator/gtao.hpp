// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/depth/layers.hpp>
#include <crease/parts/estimator/half_slice.hpp>
#include <crease/parts/estimator/open_horizon.hpp>
#include <crease/parts/estimator/visibility_settings.hpp>
#include <crease/parts/output/bent_cone.hpp>
#include <crease/parts/receivers/thin_layers.hpp>
#include <crease/parts/sampler/taps.hpp>
#include <crease/parts/traversal/deferred_layers.hpp>

namespace crease {

inline constexpr glsl_file gtao_glsl{
    "estimator/gtao.glsl",
#include <crease/estimator/gtao.glsl>
};

/// Estimator: ground-truth ambient occlusion, by the horizons of half slices. As the public implementation
/// has it with a radius of 1.457 times that of the effect.
struct gtao {
    using needs = traits<slice_taps, depth_layers>;
    static constexpr setting reads[] = {
        {"falloff", 0.615f, 0, 1,
         "outer share of the radius over which a horizon falls to the tangent plane"},
        {"thin_occluders", 0, 0, 16,
         "by how much more what is nearer to the camera than the receiver counts as far"},
        strength_setting(1),
        exponent_setting(1),
    };
    static constexpr const glsl_file* files[] = {&open_horizon_glsl, &half_slice_glsl, &gtao_glsl};
    static constexpr part description{
        .kind = role::estimator,
        .name = "gtao",
        .summary = "the cosine-weighted integral over the horizons of half slices",
        .source = "Jimenez et al. 2016, Practical Realtime Strategies for Accurate Indirect Occlusion",
        .files = files,
        .settings = reads,
        .needs = needs::list,
        .offers = traits<layers_behind, open_directions, both_sides>::list,
    };
};

}
