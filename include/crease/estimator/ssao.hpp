// SPDX-License-Identifier: MIT
#pragma once

#include <crease/depth/layers.hpp>
#include <crease/fold/front_first.hpp>
#include <crease/output/bent_cone.hpp>
#include <crease/sampler/taps.hpp>
#include <crease/view/second_view.hpp>

namespace crease {

inline constexpr glsl_file ssao_glsl{
    "estimator/ssao.glsl",
#include <crease/estimator/ssao.glsl>
};

inline constexpr glsl_file ssao_front_glsl{
    "estimator/ssao_front.glsl",
#include <crease/estimator/ssao_front.glsl>
};

inline constexpr glsl_file ssao_bent_glsl{
    "estimator/ssao_bent.glsl",
#include <crease/estimator/ssao_bent.glsl>
};

/// Estimator: screen-space ambient occlusion by range-checked points. The defaults aim at the `linear` truth.
struct ssao {
    using needs = traits<point_taps, depth_layers>;
    static constexpr extra more[] = {{&front_test::value, &ssao_front_glsl},
                                     {&open_directions::value, &ssao_bent_glsl}};
    static constexpr setting reads[] = {
        {"bias", &parameters::bias, 0.01f, 0, 1,
         "height over the tangent plane, in radii, below which a point is left out"},
        {"strength", &parameters::strength, 0.75f, 0, 16, "factor of the occlusion"},
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
        .offers = traits<front_test, open_directions, any_eye>::list,
        .extras = more,
        .fold = &fold_max_glsl,
    };
};

}
