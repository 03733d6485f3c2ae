// SPDX-License-Identifier: MIT
#pragma once

#include <crease/depth/layers.hpp>
#include <crease/estimator/bent_turn.hpp>
#include <crease/fold/deferred_layers.hpp>
#include <crease/output/bent_cone.hpp>
#include <crease/sampler/taps.hpp>

namespace crease {

inline constexpr glsl_file hbao_glsl{
    "estimator/hbao.glsl",
#include <crease/estimator/hbao.glsl>
};

inline constexpr glsl_file hbao_front_glsl{
    "estimator/hbao_front.glsl",
#include <crease/estimator/hbao_front.glsl>
};

inline constexpr glsl_file hbao_deferred_glsl{
    "estimator/hbao_deferred.glsl",
#include <crease/estimator/hbao_deferred.glsl>
};

inline constexpr glsl_file hbao_bent_glsl{
    "estimator/hbao_bent.glsl",
#include <crease/estimator/hbao_bent.glsl>
};

/// Estimator: horizon-based ambient occlusion. The defaults aim at the `linear` truth.
struct hbao {
    using needs = traits<ordered_taps, depth_layers>;
    static constexpr extra more[] = {{&front_test::value, &hbao_front_glsl},
                                     {&resumption::value, &hbao_deferred_glsl},
                                     {&open_directions::value, &bent_turn_glsl},
                                     {&open_directions::value, &hbao_bent_glsl}};
    static constexpr setting reads[] = {
        {"bias", &parameters::bias, 0.2f, 0, 1.5f, "angle added to the tangent's, radians"},
        {"threshold", &parameters::threshold, 0, -1, 1,
         "least cosine between the normal and a tap that counts"},
        {"strength", &parameters::strength, 1.15f, 0, 16, "factor of the occlusion"},
        {"exponent", &parameters::exponent, 1, 0.01f, 16, "power of the visibility"},
    };
    static constexpr part description{
        .kind = role::estimator,
        .name = "hbao",
        .summary = "horizons over the tangent plane, with a quadratic falloff",
        .source = "stochastic-depth-ao 2020, 4.2 and 4.4, Algorithm 2",
        .glsl = &hbao_glsl,
        .settings = reads,
        .needs = needs::list,
        .offers = traits<front_test, resumption, open_directions>::list,
        .extras = more,
        .fold = &fold_max_glsl,
    };
};

}
