// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/receivers/surfaces.hpp>

namespace crease {

inline constexpr glsl_file thin_layers_glsl{
    "receivers/thin_layers.glsl",
#include <crease/receivers/thin_layers.glsl>
};

/// Works for a receiver that is looked at from behind: its normal and its way to the eye both turned round,
/// as crease_eye_side tells.
CREASE_TRAIT(both_sides, estimator,
             "the receivers have two sides, and the estimator sees that side alone which faces the camera");

/// Receivers: every layer that the depth source keeps of a texel, merged by opacity. Surfaces are thin hulls:
/// the hemispheres of both sides count, by the opacity.
struct thin_layers {
    using needs = traits<layers_with_opacity, layers_with_normals, layers_alone, both_sides>;
    static constexpr const glsl_file* files[] = {&thin_layers_glsl, &surfaces_glsl};
    static constexpr part description{
        .kind = role::receivers,
        .name = "thin_layers",
        .summary = "every layer, as thin hulls with an exterior and an interior, merged by opacity",
        .source = "a-buffer-ssao 2013, III, (2) to (4)",
        .files = files,
        .needs = needs::list,
        .offers = traits<blended_layers>::list,
    };
};

}
