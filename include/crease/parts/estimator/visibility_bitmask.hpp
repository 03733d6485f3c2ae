// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/depth/layers.hpp>
#include <crease/parts/estimator/half_slice.hpp>
#include <crease/parts/estimator/opacity_sectors.hpp>
#include <crease/parts/estimator/open_horizon.hpp>
#include <crease/parts/estimator/visibility_settings.hpp>
#include <crease/parts/output/bent_cone.hpp>
#include <crease/parts/receivers/thin_layers.hpp>
#include <crease/parts/sampler/taps.hpp>
#include <crease/parts/traversal/deferred_layers.hpp>

namespace crease {

inline constexpr glsl_file visibility_bitmask_glsl{
    "estimator/visibility_bitmask.glsl",
#include <crease/estimator/visibility_bitmask.glsl>
};

/// Estimator: the even sectors of half slices that layers of a thickness hide. The defaults aim at the `hard`
/// truth.
struct visibility_bitmask {
    using needs = traits<slice_taps, depth_layers>;
    static constexpr setting reads[] = {
        {"thickness", 0.4f, 0, 64, "of a layer, away from the eye, radii"},
        strength_setting(1),
        exponent_setting(1),
    };
    static constexpr const glsl_file* files[] = {&open_horizon_glsl, &half_slice_glsl, &opacity_sectors_glsl,
                                                 &visibility_bitmask_glsl};
    static constexpr part description{
        .kind = role::estimator,
        .name = "visibility_bitmask",
        .summary = "the even sectors of half slices that layers of a thickness hide",
        .source = "Therrien et al. 2023, Screen Space Indirect Lighting with Visibility Bitmask",
        .files = files,
        .settings = reads,
        .needs = needs::list,
        .offers = traits<layers_behind, open_directions, both_sides>::list,
    };
};

}
