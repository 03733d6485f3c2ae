// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/depth/layers.hpp>
#include <crease/parts/estimator/open_horizon.hpp>
#include <crease/parts/estimator/visibility_settings.hpp>
#include <crease/parts/output/bent_cone.hpp>
#include <crease/parts/receivers/thin_layers.hpp>
#include <crease/parts/sampler/taps.hpp>
#include <crease/parts/traversal/deferred_layers.hpp>

namespace crease {

inline constexpr glsl_file hbao_glsl{
    "estimator/hbao.glsl",
#include <crease/estimator/hbao.glsl>
};

/// Estimator: horizon-based ambient occlusion. The defaults aim at the `linear` truth.
struct hbao {
    using needs = traits<ordered_taps, depth_layers>;
    static constexpr setting reads[] = {
        {"bias", 0.2f, 0, 1.5f, "angle added to the tangent's, radians"},
        {"threshold", 0, -1, 1, "least cosine between the normal and a tap that counts"},
        strength_setting(1.15f),
        exponent_setting(1),
    };
    static constexpr const glsl_file* files[] = {&open_horizon_glsl, &hbao_glsl};
    static constexpr part description{
        .kind = role::estimator,
        .name = "hbao",
        .summary = "horizons over the tangent plane, with a quadratic falloff",
        .source = "stochastic-depth-ao 2020, 4.2 and 4.4, Algorithm 2",
        .files = files,
        .settings = reads,
        .needs = needs::list,
        .offers = traits<layers_behind, open_directions, both_sides>::list,
    };
};

}
