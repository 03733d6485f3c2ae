// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/depth/layers.hpp>
#include <crease/parts/estimator/opacity_sectors.hpp>
#include <crease/parts/estimator/open_horizon.hpp>
#include <crease/parts/estimator/visibility_settings.hpp>
#include <crease/parts/output/bent_cone.hpp>
#include <crease/parts/receivers/thin_layers.hpp>
#include <crease/parts/sampler/taps.hpp>
#include <crease/parts/traversal/deferred_layers.hpp>

namespace crease {

inline constexpr glsl_file cosine_bitmask_glsl{
    "estimator/cosine_bitmask.glsl",
#include <crease/estimator/cosine_bitmask.glsl>
};

inline constexpr glsl_file cosine_bitmask_opacity_march_glsl{
    "estimator/cosine_bitmask_opacity_march.glsl",
#include <crease/estimator/cosine_bitmask_opacity_march.glsl>
};

inline constexpr glsl_file cosine_bitmask_opacity_glsl{
    "estimator/cosine_bitmask_opacity.glsl",
#include <crease/estimator/cosine_bitmask_opacity.glsl>
};

struct cosine_bitmask_part {
    using needs = traits<slice_taps, depth_layers>;
    static constexpr number takes[] = {
        {"linear", 0, 1, 0,
         "0: what is within the radius occludes, as the hard truth; 1: by 1 - distance / radius, as the "
         "linear"},
        {"isolated", 0, 1, 1,
         "1: what is nearer than the taps on both sides of it is no thicker than they are apart"},
    };
    static constexpr setting reads[] = {
        {"thickness", 0.4f, 0, 64, "of what a layer is the front of, in depth, radii"},
        strength_setting(1),
        exponent_setting(1),
    };
    static constexpr const glsl_file* files[] = {&open_horizon_glsl, &opacity_sectors_glsl,
                                                 &cosine_bitmask_glsl};
    static constexpr const glsl_file* fading[] = {&cosine_bitmask_opacity_march_glsl,
                                                  &cosine_bitmask_opacity_glsl};
    static constexpr files_where more[] = {{&layers_with_opacity::value, fading}};
    static constexpr part description{
        .kind = role::estimator,
        .name = "cosine_bitmask",
        .summary = "the sectors of the cosine lobe that layers of a thickness hide",
        .source = "Therrien et al. 2023, with sectors of equal cosine-weighted measure",
        .files = files,
        .widened = more,
        .numbers = takes,
        .settings = reads,
        .needs = needs::list,
        .offers = traits<layers_behind, open_directions, both_sides>::list,
    };
};

/// Estimator: the sectors of the cosine lobe that layers of a thickness hide. Aims at the `hard` truth, or
/// where `Linear` is 1 at the `linear` one. Where `Isolated` is 1, thin things cast less of a dark rim.
template <int Linear = 0, int Isolated = 1>
struct cosine_bitmask : cosine_bitmask_part {
    static constexpr int numbers[] = {Linear, Isolated};
};

}
