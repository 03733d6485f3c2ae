// SPDX-License-Identifier: MIT
#pragma once

#include <crease/fold/groups.hpp>

namespace crease {

inline constexpr glsl_file all_layers_glsl{
    "fold/all_layers.glsl",
#include <crease/fold/all_layers.glsl>
};

inline constexpr glsl_file front_kept_glsl{
    "fold/front_kept.glsl",
#include <crease/fold/front_kept.glsl>
};

/// Looks at nothing but the layers of the depth source, whichever camera's they are.
CREASE_TRAIT(
    any_view, fold,
    "the second view needs a fold that looks at no depth image, as there is none of the second camera");

/// Fold: the layer that occludes the most, of all that a tap finds. The default of a depth source that
/// captures layers.
struct all_layers {
    static constexpr const glsl_file* helpers[] = {&fold_groups_glsl};
    static constexpr part description{
        .kind = role::fold,
        .name = "all_layers",
        .summary = "looks at all layers of every tap",
        .source = "stochastic-depth-ao 2020, 6.2",
        .glsl = &all_layers_glsl,
        .helpers = helpers,
        .offers = traits<any_view>::list,
        .packs = &front_kept_glsl,
    };
};

}
