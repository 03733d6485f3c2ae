// SPDX-License-Identifier: MIT
#pragma once

#include <crease/depth/layers.hpp>
#include <crease/estimator/bent_turn.hpp>
#include <crease/fold/deferred_layers.hpp>
#include <crease/output/bent_cone.hpp>
#include <crease/sampler/taps.hpp>
#include <crease/view/second_view.hpp>

namespace crease {

inline constexpr glsl_file hbao_plus_glsl{
    "estimator/hbao_plus.glsl",
#include <crease/estimator/hbao_plus.glsl>
};

inline constexpr glsl_file hbao_plus_front_glsl{
    "estimator/hbao_plus_front.glsl",
#include <crease/estimator/hbao_plus_front.glsl>
};

inline constexpr glsl_file hbao_plus_deferred_glsl{
    "estimator/hbao_plus_deferred.glsl",
#include <crease/estimator/hbao_plus_deferred.glsl>
};

inline constexpr glsl_file hbao_plus_bent_glsl{
    "estimator/hbao_plus_bent.glsl",
#include <crease/estimator/hbao_plus_bent.glsl>
};

/// Estimator: normal-projected obscurance, HBAO+. The defaults aim at the `linear` truth.
struct hbao_plus {
    using needs = traits<screen_taps, depth_layers>;
    static constexpr extra more[] = {{&front_test::value, &hbao_plus_front_glsl},
                                     {&resumption::value, &hbao_plus_deferred_glsl},
                                     {&open_directions::value, &bent_turn_glsl},
                                     {&open_directions::value, &hbao_plus_bent_glsl}};
    static constexpr setting reads[] = {
        {"bias", &parameters::bias, 0.15f, 0, 1, "cosine between the normal and a tap that is taken off"},
        {"strength", &parameters::strength, 2.4f, 0, 16, "factor of the occlusion"},
        {"exponent", &parameters::exponent, 2, 0.01f, 16, "power of the visibility"},
    };
    static constexpr part description{
        .kind = role::estimator,
        .name = "hbao_plus",
        .summary = "taps projected onto the normal, with a quadratic falloff",
        .source = "stochastic-depth-ao 2020, 4.3, Algorithm 3",
        .glsl = &hbao_plus_glsl,
        .settings = reads,
        .needs = needs::list,
        .offers = traits<front_test, resumption, open_directions, any_eye>::list,
        .extras = more,
        .fold = &fold_max_glsl,
    };
};

}
