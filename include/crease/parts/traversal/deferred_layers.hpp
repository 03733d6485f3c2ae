// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/traversal/front.hpp>

namespace crease {

inline constexpr glsl_file deferred_layers_glsl{
    "traversal/deferred_layers.glsl",
#include <crease/traversal/deferred_layers.glsl>
};

/// Can add a layer behind the front one of a tap after later taps were added: crease_add_behind.
CREASE_TRAIT(layers_behind, estimator,
             "the layer traversal comes back to a tap after others, and the estimator cannot add to it then");

struct deferred_layers_part : front_part {
    static constexpr number takes[] = {
        front_part::takes[0],
        {"looks", 1, 4, 1,
         "behind how many of each four taps in a row to look, the first where that may matter"},
    };
    using needs = traits<layers_behind_front, layers_behind, one_resolution>;
    static constexpr const glsl_file* files[] = {&front_glsl, &deferred_layers_glsl};
    static constexpr part description{
        .kind = role::layer_traversal,
        .name = "deferred_layers",
        .summary = "looks at all front surfaces first, and then behind the first of each few taps where that "
                   "may matter",
        .source = "stochastic-depth-ao 2020, 6.3, without a branch",
        .files = files,
        .numbers = takes,
        .settings = reads,
        .needs = needs::list,
    };
};

/// Layer traversal: all front surfaces first, and then the layers behind the first `Looks` of each four taps
/// in a row where they may add occlusion, nearest to the receiver first. Its cost does not depend on the
/// picture. Hidden layers are compared with the direction's final horizon, so this underestimates slightly
/// against `front_first`.
template <int Angle = 1, int Looks = 1>
struct deferred_layers : deferred_layers_part {
    static constexpr int numbers[] = {Angle, Looks};
};

}
