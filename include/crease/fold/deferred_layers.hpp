// SPDX-License-Identifier: MIT
#pragma once

#include <crease/fold/front.hpp>
#include <crease/output/occlusion_alone.hpp>
#include <crease/sampler/taps.hpp>

namespace crease {

inline constexpr glsl_file deferred_layers_glsl{
    "fold/deferred_layers.glsl",
#include <crease/fold/deferred_layers.glsl>
};

/// Takes up an estimate again where it was in a direction: crease_estimate_resume, crease_front_again and
/// crease_estimate_raise.
CREASE_TRAIT(resumption, estimator,
             "the fold comes back to a tap after others, and the estimator cannot resume there");

struct deferred_layers_part : front_part {
    using needs = traits<indexed_taps, front_test, resumption, any_order>;
    static constexpr const glsl_file* helpers[] = {&fold_groups_glsl, &fold_front_glsl};
    static constexpr part description{
        .kind = role::fold,
        .name = "deferred_layers",
        .summary =
            "looks at all front surfaces first, and then, tap after tap, behind those where that may matter",
        .source = "stochastic-depth-ao 2020, 6.3, in two loops",
        .helpers = helpers,
        .numbers = takes,
        .settings = reads,
        .needs = needs::list,
        .gather = &deferred_layers_glsl,
        .packs = &front_dropped_glsl,
    };
};

/// Fold: all front surfaces first, and the layers behind them, only where they may matter, in a loop of their
/// own. What lies behind a front surface counts from the horizon of the whole direction, so an estimator with
/// horizons finds a little less than with `front_first`.
template <int Angle = 1>
struct deferred_layers : deferred_layers_part {
    static constexpr int numbers[] = {Angle};
};

}
