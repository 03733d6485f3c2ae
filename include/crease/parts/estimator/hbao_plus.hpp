// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/depth/layers.hpp>
#include <crease/parts/estimator/open_horizon.hpp>
#include <crease/parts/estimator/visibility_settings.hpp>
#include <crease/parts/output/bent_cone.hpp>
#include <crease/parts/receivers/thin_layers.hpp>
#include <crease/parts/sampler/taps.hpp>
#include <crease/parts/traversal/deferred_layers.hpp>
#include <crease/parts/view/second_view.hpp>

namespace crease {

inline constexpr glsl_file hbao_plus_glsl{
    "estimator/hbao_plus.glsl",
#include <crease/estimator/hbao_plus.glsl>
};

/// Estimator: normal-projected obscurance, HBAO+. The defaults aim at the `linear` truth.
struct hbao_plus {
    using needs = traits<screen_taps, depth_layers>;
    static constexpr setting reads[] = {
        {"bias", 0.15f, 0, 1, "taken off the cosine between the normal and a tap"},
        strength_setting(2.4f),
        exponent_setting(2),
    };
    static constexpr const glsl_file* files[] = {&open_horizon_glsl, &hbao_plus_glsl};
    static constexpr part description{
        .kind = role::estimator,
        .name = "hbao_plus",
        .summary = "taps projected onto the normal, with a quadratic falloff",
        .source = "stochastic-depth-ao 2020, 4.3, Algorithm 3",
        .files = files,
        .settings = reads,
        .needs = needs::list,
        .offers = traits<layers_behind, open_directions, any_eye, both_sides>::list,
    };
};

}
