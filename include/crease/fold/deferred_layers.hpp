// SPDX-License-Identifier: MIT
#pragma once

#include <crease/fold/front.hpp>
#include <crease/output/occlusion_alone.hpp>

namespace crease {

inline constexpr glsl_file deferred_layers_glsl{
    "fold/deferred_layers.glsl",
#include <crease/fold/deferred_layers.glsl>
};

/// Takes up an estimate again where it was in a direction: crease_estimate_resume, crease_estimate_least and
/// crease_estimate_raise.
CREASE_TRAIT(resumption, estimator,
             "the fold comes back to a tap after others, and the estimator cannot resume there");

struct deferred_layers_part : front_part {
    static constexpr number takes[] = {
        front_part::takes[0],
        {"looks", 1, 4, 1,
         "taps of each four in a row behind which to look, the first where that may matter"},
    };
    using needs = traits<front_test, resumption, any_order>;
    static constexpr const glsl_file* helpers[] = {&fold_groups_glsl, &fold_front_glsl};
    static constexpr part description{
        .kind = role::fold,
        .name = "deferred_layers",
        .summary = "looks at all front surfaces first, and then behind the first of each few taps where that "
                   "may matter",
        .source = "stochastic-depth-ao 2020, 6.3, without a branch",
        .helpers = helpers,
        .numbers = takes,
        .settings = reads,
        .needs = needs::list,
        .gather = &deferred_layers_glsl,
        .packs = &front_dropped_glsl,
    };
};

/// Fold: all front surfaces first, and then the layers behind the first `Looks` of each four taps in a row
/// where they may matter; first is nearest to the receiver. Its cost does not depend on the picture. What
/// lies behind a front surface counts from the horizon of the whole direction, so an estimator finds a little
/// less than with `front_first`.
template <int Angle = 1, int Looks = 1>
struct deferred_layers : deferred_layers_part {
    static constexpr int numbers[] = {Angle, Looks};
};

}
