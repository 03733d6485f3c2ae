// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/depth/layers.hpp>
#include <crease/parts/estimator/visibility_settings.hpp>
#include <crease/parts/output/bent_cone.hpp>
#include <crease/parts/receivers/thin_layers.hpp>
#include <crease/parts/sampler/taps.hpp>
#include <crease/parts/traversal/front_first.hpp>
#include <crease/parts/view/second_view.hpp>

namespace crease {

inline constexpr glsl_file ssao_glsl{
    "estimator/ssao.glsl",
#include <crease/estimator/ssao.glsl>
};

/// Estimator: screen-space ambient occlusion by range-checked points. The defaults aim at the `linear` truth.
struct ssao {
    using needs = traits<point_taps, depth_layers>;
    static constexpr setting reads[] = {
        {"bias", 0.01f, 0, 1, "height over the tangent plane, in radii, below which a point is left out"},
        strength_setting(0.75f),
        exponent_setting(2),
    };
    static constexpr const glsl_file* files[] = {&ssao_glsl};
    static constexpr part description{
        .kind = role::estimator,
        .name = "ssao",
        .summary = "the share of points in the hemisphere that are behind a surface near enough",
        .source = "stochastic-depth-ao 2020, 4.1, Algorithm 1",
        .files = files,
        .settings = reads,
        .needs = needs::list,
        .offers = traits<open_directions, any_eye, both_sides>::list,
    };
};

}
